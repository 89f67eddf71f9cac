#include "app/io/byte_channel.hpp"

#include "tests/app/io/event_loop.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QThread>
#include <QUdpSocket>

namespace echotrail {
namespace {

class OverEveryLink : public testing::TestWithParam<const char*> {};

TEST_P(OverEveryLink, BytesGoBothWaysUnchanged) {
    Listener head(GetParam());
    Caller host(head.address());
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    host.channel->send(everyByte());
    ASSERT_TRUE(becomes([&] { return head.heard.size() >= 256; }));
    EXPECT_EQ(head.heard, everyByte());
    EXPECT_EQ(head.ups, 1);
    QByteArray long_reply;
    for (int i = 0; i < 8; ++i) long_reply += everyByte();
    head.server->send(long_reply);
    ASSERT_TRUE(becomes([&] { return host.heard.size() >= long_reply.size(); }));
    EXPECT_EQ(host.heard, long_reply);
    EXPECT_EQ(host.channel->counts().bytes_out, 256U);
    EXPECT_EQ(host.channel->counts().bytes_in, static_cast<std::uint64_t>(long_reply.size()));
    EXPECT_EQ(host.channel->counts().dropped_bytes, 0U);
    EXPECT_TRUE(host.reasons.empty());
}

TEST_P(OverEveryLink, AClosedChannelOpensAgain) {
    Listener head(GetParam());
    Caller host(head.address());
    for (int time = 1; time <= 3; ++time) {
        ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
        host.channel->send("again");
        ASSERT_TRUE(becomes([&] { return head.heard.size() == 5 * time; }));
        host.channel->close();
        EXPECT_FALSE(host.channel->isUp());
        EXPECT_EQ(host.reasons, QStringList(time, "closed"));
        host.channel->open();
    }
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    EXPECT_EQ(host.channel->counts().times_up, 4U);
}

TEST_P(OverEveryLink, WhatIsSentWhileDownIsDroppedAndCounted) {
    Listener head(GetParam());
    Caller host(head.address());
    host.channel->close();
    host.channel->send("nobody");
    EXPECT_EQ(host.channel->counts().dropped_bytes, 6U);
    EXPECT_EQ(host.channel->counts().bytes_out, 0U);
}

TEST_P(OverEveryLink, LivesOnAThreadOfItsOwn) {
    Listener head(GetParam());
    QThread thread;
    auto channel = makeChannel(parseLinkAddress(head.address()).value());
    auto* const moved = channel.release();
    moved->moveToThread(&thread);
    QObject::connect(&thread, &QThread::started, moved, &ByteChannel::open);
    QObject::connect(moved, &ByteChannel::wentUp, moved, [moved] { moved->send("hello"); });
    QObject::connect(&thread, &QThread::finished, moved, &QObject::deleteLater);
    thread.start();
    EXPECT_TRUE(becomes([&] { return head.heard == "hello"; }));
    thread.quit();
    EXPECT_TRUE(thread.wait());
}

TEST_P(OverEveryLink, NothingIsLeftOfAChannelThatGoesWhileUp) {
    Listener head(GetParam());
    auto host = std::make_unique<Caller>(head.address());
    ASSERT_TRUE(becomes([&] { return host->channel->isUp(); }));
    host->channel->send("x");
    ASSERT_TRUE(becomes([&] { return head.ups == 1; }));
    host.reset();
    head.server->send(everyByte());
    Caller next(head.address());
    EXPECT_TRUE(becomes([&] { return next.channel->isUp(); }));
}

INSTANTIATE_TEST_SUITE_P(ByteChannel, OverEveryLink, testing::Values("tcp://127.0.0.1:0", "udp://127.0.0.1:0", "pty"),
                         [](const auto& link) { return QString(link.param).section(':', 0, 0).toStdString(); });

TEST(ByteChannel, TcpComesBackWhenTheServerDropsIt) {
    Listener head("tcp://127.0.0.1:0");
    Caller host(head.address());
    for (std::uint64_t time = 1; time <= 3; ++time) {
        ASSERT_TRUE(becomes([&] { return host.channel->counts().times_up == time && head.ups == int(time); }));
        head.server->send("ping");
        ASSERT_TRUE(becomes([&] { return host.heard.size() == 4 * int(time); }));
        head.server->drop();
        ASSERT_TRUE(becomes([&] { return !host.channel->isUp(); }));
        EXPECT_EQ(host.reasons.size(), int(time)) << host.reasons.join("|").toStdString();
    }
    EXPECT_TRUE(host.reasons.first().startsWith(QString::fromStdString(head.address())));
}

TEST(ByteChannel, TcpWaitsForAServerThatIsNotThereYetAndSaysSoOnce) {
    auto head = std::make_unique<Listener>("tcp://127.0.0.1:0");
    const std::string address = head->address();
    head.reset();
    Caller host(address);
    ASSERT_TRUE(becomes([&] { return host.reasons.size() == 1; }));
    EXPECT_TRUE(host.reasons.first().contains("refused")) << host.reasons.first().toStdString();
    Listener later(address);
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    EXPECT_EQ(host.reasons.size(), 1);
}

TEST(ByteChannel, ANewTcpPeerTakesThePlaceOfTheOld) {
    Listener head("tcp://127.0.0.1:0");
    Caller first(head.address());
    ASSERT_TRUE(becomes([&] { return head.ups == 1; }));
    Caller second(head.address());
    ASSERT_TRUE(becomes([&] { return head.ups == 2; }));
    first.channel->close();
    second.channel->send("mine");
    EXPECT_TRUE(becomes([&] { return head.heard == "mine"; }));
    EXPECT_EQ(head.downs, 1);
}

TEST(ByteChannel, ASlowPeerBoundsWhatWaitsForIt) {
    Listener head("tcp://127.0.0.1:0");
    Caller host(head.address());
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    // No event loop between: nothing leaves.
    const QByteArray block(10'000, 'x');
    for (int i = 0; i < 100; ++i) host.channel->send(block);
    const ChannelCounts counts = host.channel->counts();
    EXPECT_GT(counts.bytes_out, 0U);
    EXPECT_GT(counts.dropped_bytes, 0U);
    EXPECT_EQ(counts.bytes_out + counts.dropped_bytes, 1'000'000U);
    EXPECT_TRUE(becomes([&] { return std::uint64_t(head.heard.size()) == counts.bytes_out; }));
}

TEST(ByteChannel, UdpDatagramsFromAnotherMachineAreForeign) {
    QUdpSocket probe;
    ASSERT_TRUE(probe.bind(QHostAddress::LocalHost, 0));
    const quint16 port = probe.localPort();
    probe.close();
    // 127.0.0.2 is the device; what 127.0.0.1 says is not for us.
    Caller host("udp://127.0.0.2:9?listen=" + std::to_string(port));
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    QUdpSocket stranger, device;
    ASSERT_TRUE(stranger.bind(QHostAddress::LocalHost, 0));
    ASSERT_TRUE(device.bind(QHostAddress("127.0.0.2"), 0));
    stranger.writeDatagram("stranger", QHostAddress::LocalHost, port);
    device.writeDatagram("", QHostAddress::LocalHost, port);
    device.writeDatagram("device\r \n", QHostAddress::LocalHost, port);
    ASSERT_TRUE(becomes([&] { return host.heard.size() >= 9; }));
    EXPECT_EQ(host.heard, "device\r \n");
    EXPECT_EQ(host.channel->counts().foreign, 1U);
}

TEST(ByteChannel, AUdpPortThatIsTakenIsTriedAgain) {
    auto taken = std::make_unique<QUdpSocket>();
    ASSERT_TRUE(taken->bind(QHostAddress::AnyIPv4, 0, QAbstractSocket::DontShareAddress));
    Caller host("udp://127.0.0.1:9?listen=" + std::to_string(taken->localPort()));
    ASSERT_TRUE(becomes([&] { return host.reasons.size() == 1; }));
    EXPECT_TRUE(host.reasons.first().startsWith("UDP port ")) << host.reasons.first().toStdString();
    taken.reset();
    EXPECT_TRUE(becomes([&] { return host.channel->isUp(); }));
}

/// A device path that an adapter comes and goes under, as /dev/serial/by-id does.
class SerialAdapter : public testing::Test {
protected:
    std::string path() const { return folder_.filePath("adapter").toStdString(); }
    void plugIn() {
        head_ = std::make_unique<Listener>("pty");
        const auto device = QString::fromStdString(head_->address().substr(sizeof "serial://" - 1));
        ASSERT_TRUE(QFile::link(device, QString::fromStdString(path())));
    }
    void pullOut() {
        head_.reset();
        ASSERT_TRUE(QFile::remove(QString::fromStdString(path())));
    }
    QTemporaryDir folder_;
    std::unique_ptr<Listener> head_;
};

TEST_F(SerialAdapter, ThatIsPulledOutAndComesBackIsOpenedAgain) {
    plugIn();
    Caller host("serial://" + path());
    for (int time = 1; time <= 2; ++time) {
        ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
        host.channel->send("go");
        ASSERT_TRUE(becomes([&] { return head_->heard == "go"; }));
        pullOut();
        ASSERT_TRUE(becomes([&] { return !host.channel->isUp(); }));
        EXPECT_TRUE(host.reasons.last().startsWith(QString::fromStdString(path()) + ": "));
        plugIn();
    }
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    EXPECT_EQ(host.channel->counts().times_up, 3U);
}

TEST_F(SerialAdapter, ThatIsNotThereIsWaitedForAndNamedOnce) {
    Caller host("serial://" + path());
    EXPECT_EQ(host.reasons,
              QStringList(QString::fromStdString(path()) + ": there is no such device; is it plugged in?"));
    plugIn();
    ASSERT_TRUE(becomes([&] { return host.channel->isUp(); }));
    EXPECT_EQ(host.reasons.size(), 1);
}

TEST(ByteChannel, AFileIsNoSerialPort) {
    QTemporaryDir folder;
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    Caller host("serial://" + file.fileName().toStdString());
    EXPECT_FALSE(host.channel->isUp());
    EXPECT_EQ(host.reasons.size(), 1) << host.reasons.join("|").toStdString();
}

}  // namespace
}  // namespace echotrail
