#include "app/io/report_sender.hpp"

#include "tests/app/io/event_loop.hpp"

#include <gtest/gtest.h>

#include <QTcpServer>
#include <QTcpSocket>

namespace echotrail {
namespace {

std::unique_ptr<ReportSender> senderTo(const std::string& address) {
    return ReportSender::open(parseLinkAddress(address).value()).value();
}

TEST(ReportSender, EveryReportIsALineOfItsOwn) {
    for (const char* form : {"tcp://127.0.0.1:0", "udp://127.0.0.1:0"}) {
        Listener controller(form);
        const auto sender = senderTo(controller.address());
        ASSERT_TRUE(becomes([&] { return sender->channel().isUp(); }));
        sender->send(R"({"track":1})");
        sender->send("$RATTM,01*00\r");
        ASSERT_TRUE(becomes([&] { return controller.heard.count('\n') == 2; }));
        EXPECT_EQ(controller.heard, "{\"track\":1}\n$RATTM,01*00\r\n");
        EXPECT_EQ(sender->counts().sent, 2U);
        EXPECT_EQ(sender->counts().dropped, 0U);
    }
}

TEST(ReportSender, AUdpDatagramHoldsOneReport) {
    Listener controller("udp://127.0.0.1:0");
    QList<QByteArray> datagrams;
    QObject::connect(controller.server.get(), &ByteServer::received,
                     [&](const QByteArray& bytes) { datagrams += bytes; });
    const auto sender = senderTo(controller.address());
    ASSERT_TRUE(becomes([&] { return sender->channel().isUp(); }));
    for (int i = 0; i < 3; ++i) sender->send("report " + std::to_string(i));
    ASSERT_TRUE(becomes([&] { return datagrams.size() == 3; }));
    EXPECT_EQ(datagrams, (QList<QByteArray>{"report 0\n", "report 1\n", "report 2\n"}));
}

TEST(ReportSender, NothingIsKeptForAControllerThatIsNotThere) {
    auto controller = std::make_unique<Listener>("tcp://127.0.0.1:0");
    const std::string address = controller->address();
    controller.reset();
    const auto sender = senderTo(address);
    sender->send("too early");
    EXPECT_EQ(sender->counts().dropped, 1U);
    Listener later(address);
    ASSERT_TRUE(becomes([&] { return sender->channel().isUp(); }));
    sender->send("in time");
    ASSERT_TRUE(becomes([&] { return later.heard.contains('\n'); }));
    EXPECT_EQ(later.heard, "in time\n");
}

TEST(ReportSender, ASlowControllerLosesWholeReportsAndTheyAreCounted) {
    QTcpServer slow;
    ASSERT_TRUE(slow.listen(QHostAddress::LocalHost));
    const auto sender = senderTo("tcp://127.0.0.1:" + std::to_string(slow.serverPort()));
    ASSERT_TRUE(becomes([&] { return sender->channel().isUp() && slow.hasPendingConnections(); }));
    QTcpSocket* const peer = slow.nextPendingConnection();
    peer->setReadBufferSize(1024);
    const std::string report(500, 'r');
    std::uint64_t given = 0;
    ASSERT_TRUE(becomes([&] {
        for (int i = 0; i < 100; ++i, ++given) sender->send(report);
        return sender->counts().dropped > 0 && given > 20'000;
    }));
    EXPECT_EQ(sender->counts().sent + sender->counts().dropped, given);
    QByteArray heard;
    peer->setReadBufferSize(0);
    ASSERT_TRUE(becomes([&] {
        heard += peer->readAll();
        return std::uint64_t(heard.size()) == sender->counts().sent * (report.size() + 1);
    }));
    EXPECT_EQ(std::uint64_t(heard.count('\n')), sender->counts().sent);
}

TEST(ReportSender, OnlyNetworkAddressesWithAPortTakeReports) {
    for (const char* text : {"pty", "serial:///dev/ttyS0", "udp://127.0.0.1:0", "tcp://127.0.0.1:0"}) {
        const auto sender = ReportSender::open(parseLinkAddress(text).value());
        ASSERT_FALSE(sender) << text;
        EXPECT_NE(sender.error().find("say udp://HOST:PORT"), std::string::npos);
    }
}

}  // namespace
}  // namespace echotrail
