#include "app/io/console_server.hpp"
#include "app/io/tls_channel.hpp"
#include "app/io/tracker_link.hpp"
#include "core/runtime/link_moment.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/app/io/slow_way.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

#include <QHostAddress>
#include <QStringList>
#include <QTemporaryDir>
#include <chrono>

namespace echotrail {
namespace {

using Role = TrustStore::Role;

Timestamp clockNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

/// A tracker that is reached by TLS, and this user as a console.
class TlsLink : public testing::Test {
protected:
    TlsLink() {
        before_ = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        QObject::connect(&server, &ConsoleServer::noted, [this](const QString& text) { notes += text; });
        address = server.listen(parseLinkAddress("tls://0.0.0.0:0").value()).value();
        address.host = "127.0.0.1";
    }
    ~TlsLink() override { before_.isEmpty() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", before_); }

    static QByteArray fingerprint(const TrustStore& trust) { return fingerprintOf(trust.own().value().certificate); }
    void trustTracker() {
        ASSERT_TRUE(shore().add({Role::Tracker, fingerprint(aboard), "vehicle", QDateTime::currentDateTimeUtc()}));
    }
    void trustConsole() {
        ASSERT_TRUE(aboard.add({Role::Console, fingerprint(shore()), "shore", QDateTime::currentDateTimeUtc()}));
    }
    static TrustStore shore() { return TrustStore::ofUser(); }
    void ping(std::uint64_t number) {
        LinkMoment moment = test::sampleMoment(number, 0.0);
        moment.beam->ping.time = moment.beam->update.time = clockNow();
        server.publish(moment);
        server.flush();
    }

    QTemporaryDir folder_;
    QByteArray before_;
    TrustStore aboard{folder_.path() + "/aboard"};
    QStringList notes;
    ConsoleServer server{{"vehicle", "test"},
                         namedValues({}),
                         clockNow,
                         [](const LinkRequest&) { return std::optional<std::vector<NamedValue>>(); },
                         aboard};
    LinkAddress address;
};

TEST_F(TlsLink, PairedSidesWorkTogether) {
    trustTracker();
    trustConsole();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().up && console.state().client.holdsControl(); }))
        << console.state().reason;
    for (std::uint64_t i = 0; i < 50; ++i) ping(i);
    std::optional<Scene> scene;
    ASSERT_TRUE(becomes([&] { return (scene = console.scenes().take()) && scene->position == 50; }));
    EXPECT_EQ(console.state().client.gaps, 0U);
    EXPECT_TRUE(server.turnedAway().empty());
}

TEST_F(TlsLink, WhoIsNotPairedIsToldWhatToDo) {
    trustTracker();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().reason.find("echotrail pair") != std::string::npos; }))
        << console.state().reason;
    EXPECT_FALSE(console.state().up);
    EXPECT_EQ(server.consoles(), 0U);
    EXPECT_GE(server.turnedAway()["not_paired"], 1U);
    ASSERT_FALSE(notes.isEmpty());
    EXPECT_NE(notes[0].indexOf("run 'echotrail pair'"), -1) << notes[0].toStdString();
    EXPECT_EQ(notes[0].indexOf('\n'), -1);

    trustConsole();
    EXPECT_TRUE(becomes([&] { return console.state().up; })) << "at once, without a restart";
}

TEST_F(TlsLink, ATrackerThatIsNotPairedIsToldNothing) {
    trustConsole();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] {
        return console.state().reason.find("not paired with this machine") != std::string::npos;
    })) << console.state().reason;
    EXPECT_EQ(console.state().client.joins, 0U);
    EXPECT_EQ(console.state().client.bytes, 0U);
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["broke_off"] > 0; }));
    EXPECT_TRUE(notes[0].contains("run 'echotrail pair'")) << notes[0].toStdString();
}

TEST_F(TlsLink, WhoIsRevokedIsDroppedAndStaysOut) {
    trustTracker();
    trustConsole();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().up; }));
    ASSERT_TRUE(aboard.revoke("shore"));
    ASSERT_TRUE(becomes([&] { return !console.state().up; }));
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["not_paired"] > 0; })) << "it comes back by itself, in vain";
    EXPECT_EQ(server.consoles(), 0U);
    EXPECT_TRUE(notes.join('\n').contains("has been revoked"));
}

TEST_F(TlsLink, ASlowWayIsNoticedThroughTls) {
    trustTracker();
    trustConsole();
    SlowWay radio(address.port, {.bytes_per_second = 16'000});
    address.port = radio.port();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().up; })) << console.state().reason;
    std::uint64_t pinged = 0;
    QTimer pings;
    QObject::connect(&pings, &QTimer::timeout, [&] { ping(pinged++); });
    pings.start(20);
    EXPECT_TRUE(becomes([&] { return server.levelOf(1) >= SendQueue::NoParticles; }))
        << "what TLS holds in its own buffer counts, too";
    EXPECT_TRUE(console.state().up);
    EXPECT_EQ(server.counts().resynchronised, 0U);
}

TEST_F(TlsLink, StrangersOfEveryKindDisturbNobody) {
    trustTracker();
    trustConsole();
    TrackerLink console(address, {"shore", "test"});
    console.open();
    ASSERT_TRUE(becomes([&] { return console.state().up; }));

    QTcpSocket plain;  // says hello as on plain TCP: fields 1 and 2 of field 2, version 1
    plain.connectToHost("127.0.0.1", address.port);
    plain.write(QByteArray("\0\0\0\6\x12\4\x08\1\x10\1", 10));
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["no_tls"] == 1; }));

    QSslSocket nobody, old;
    QSslConfiguration bare = QSslConfiguration::defaultConfiguration();
    bare.setPeerVerifyMode(QSslSocket::VerifyNone);
    nobody.setSslConfiguration(bare);
    nobody.connectToHostEncrypted("127.0.0.1", address.port);
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["no_certificate"] == 1; }));
    QSslConfiguration older = tlsConfiguration(shore().own().value(), QSslSocket::VerifyNone);
    older.setProtocol(QSsl::TlsV1_2);
    old.setSslConfiguration(older);
    old.connectToHostEncrypted("127.0.0.1", address.port);
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["no_tls"] == 2; })) << "TLS 1.2 is not taken, paired or not";

    std::vector<std::unique_ptr<QTcpSocket>> silent;
    for (int i = 0; i < 100; ++i) {
        silent.push_back(std::make_unique<QTcpSocket>());
        silent.back()->connectToHost("127.0.0.1", address.port);
    }
    ASSERT_TRUE(becomes([&] { return server.turnedAway()["too_many"] >= 80; }));
    QSslSocket other;  // comes from elsewhere
    other.bind(QHostAddress("127.0.0.2"));
    other.setSslConfiguration(tlsConfiguration(shore().own().value(), QSslSocket::VerifyNone));
    other.connectToHostEncrypted("127.0.0.1", address.port);
    EXPECT_TRUE(becomes([&] { return server.consoles() == 2; })) << "is not kept out by them";
    ping(0);
    EXPECT_TRUE(becomes([&] { return console.state().last_ping.has_value(); }));
    EXPECT_TRUE(console.state().up);
    EXPECT_EQ(server.counts().malformed, 0U) << "none has come as far as the link";
}

}  // namespace
}  // namespace echotrail
