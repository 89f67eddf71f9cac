#include "app/io/pairing.hpp"

#include "app/io/tls_channel.hpp"
#include "core/link/pairing_message.hpp"
#include "tests/app/io/event_loop.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace echotrail {
namespace {

LinkAddress anywhere() { return parseLinkAddress("tls://127.0.0.1:0").value(); }

/// A machine with what it trusts.
struct Machine {
    QTemporaryDir folder;
    TrustStore trust{folder.path() + "/link"};
    QByteArray fingerprint() const { return fingerprintOf(trust.own().value().certificate); }
};

/// One try of a console; what came of it.
struct Try {
    Try(const PairingCode& code, const Machine& console, const LinkAddress& tracker)
        : client(code, console.trust, "shore") {
        QObject::connect(&client, &PairingClient::paired, [this](const TrustStore::Peer& peer) { paired = peer; });
        QObject::connect(&client, &PairingClient::failed, [this](const QString& why) { reason = why; });
        EXPECT_TRUE(client.begin(tracker));
    }
    bool ended() {
        return becomes([this] { return paired || !reason.isEmpty(); });
    }
    PairingClient client;
    std::optional<TrustStore::Peer> paired;
    QString reason;
};

struct Waiting {
    Waiting() {
        QObject::connect(&server, &PairingServer::paired, [this](const TrustStore::Peer& peer) { paired = peer; });
        QObject::connect(&server, &PairingServer::over, [this](const QString& why) { over = why; });
        address = server.listen(anywhere()).value();
    }
    Machine vehicle;
    PairingCode code = PairingCode::make();
    PairingServer server{code, vehicle.trust, "vehicle"};
    LinkAddress address;
    std::optional<TrustStore::Peer> paired;
    QString over;
};

TEST(PairingCode, IsReadAsPeopleWriteIt) {
    const PairingCode code = PairingCode::make();
    const std::string text = code.text();
    ASSERT_EQ(text.size(), 19U);
    EXPECT_NE(text, PairingCode::make().text());
    EXPECT_EQ(PairingCode::parse(text).value().text(), text);
    EXPECT_EQ(PairingCode::parse("oil0-abcd 0123xyzw").value().text(), "0110-ABCD-0123-XYZW");
    for (const char* bad :
         {"", "0110-ABCD-0123-XYZ", "0110-ABCD-0123-XYZW0", "0110-ABCD-0123-XYZU", "0110-ABCD-0123-XYZ\n"})
        EXPECT_FALSE(PairingCode::parse(bad)) << bad;
}

TEST(PairingCode, AProofHoldsForOneSideAndTheseTwoCertificates) {
    const PairingCode code = PairingCode::parse("0000-0000-0000-0000").value();
    const QByteArray tracker(32, 'T'), console(32, 'C'), other(32, 'M');
    using enum PairingCode::Prover;
    const QByteArray proof = code.proof(Console, tracker, console);
    // By another program: python3 -c 'import hmac;print(hmac.new(bytes(10),b"echotrail pairing 1\nconsole\n"+b"T"*32+
    // b"C"*32,"sha256").hexdigest())'
    EXPECT_EQ(proof.toHex(), "523dee27a0f0f2500ef4cfe55427d9e2e9f26cb8f2d4beb22b30c192ef02bce2");
    EXPECT_FALSE(isSameProof(proof, code.proof(Tracker, tracker, console)));
    EXPECT_FALSE(isSameProof(proof, code.proof(Console, other, console)));
    EXPECT_FALSE(isSameProof(proof, code.proof(Console, tracker, other)));
    EXPECT_FALSE(isSameProof(proof, PairingCode::make().proof(Console, tracker, console)));
    EXPECT_FALSE(isSameProof(proof, proof.left(31)));
}

TEST(PairingDesk, FiveTriesFiveMinutesAndOneUse) {
    const PairingCode code = PairingCode::make();
    const QByteArray tracker(32, 'T'), console(32, 'C'), wrong(32, 0);
    const QByteArray right = code.proof(PairingCode::Prover::Console, tracker, console);
    using Verdict = PairingDesk::Verdict;
    const Microseconds early{1'000'000}, last = link_limits::pairing_lasts, late = last + Microseconds{1};
    PairingDesk tried(code);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(tried.judge(wrong, tracker, console, early), Verdict::Wrong);
    PairingDesk once = tried;
    EXPECT_EQ(once.judge(right, tracker, console, last), Verdict::Right) << "the fifth";
    EXPECT_EQ(once.judge(right, tracker, console, early), Verdict::Over) << "used";
    EXPECT_EQ(tried.judge(wrong, tracker, console, early), Verdict::Wrong);
    EXPECT_EQ(tried.judge(right, tracker, console, early), Verdict::Over) << "locked";
    EXPECT_EQ(PairingDesk(code).judge(right, tracker, console, late), Verdict::Over);
}

TEST(Pairing, WhoKnowsTheCodeIsTrustedOnBothSides) {
    Waiting aboard;
    const Machine shore;
    Try console(aboard.code, shore, aboard.address);
    ASSERT_TRUE(console.ended());
    ASSERT_TRUE(console.paired) << console.reason.toStdString();
    ASSERT_TRUE(becomes([&] { return aboard.paired.has_value(); }));
    EXPECT_EQ(console.paired->name, "vehicle");
    EXPECT_EQ(aboard.paired->name, "shore");
    EXPECT_TRUE(shore.trust.isPaired(TrustStore::Role::Tracker, aboard.vehicle.fingerprint()));
    EXPECT_TRUE(aboard.vehicle.trust.isPaired(TrustStore::Role::Console, shore.fingerprint()));
    EXPECT_FALSE(shore.trust.isPaired(TrustStore::Role::Console, aboard.vehicle.fingerprint()))
        << "it is a tracker only";

    const Machine second;
    Try again(aboard.code, second, aboard.address);
    ASSERT_TRUE(again.ended());
    EXPECT_FALSE(again.paired) << "a code is for one";
}

TEST(Pairing, FiveWrongCodesLockIt) {
    Waiting aboard;
    const Machine stranger, shore;
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(aboard.over.isEmpty()) << i;
        Try guess(PairingCode::make(), stranger, aboard.address);
        ASSERT_TRUE(guess.ended());
        EXPECT_FALSE(guess.paired);
    }
    EXPECT_FALSE(aboard.over.isEmpty());
    Try late(aboard.code, shore, aboard.address);
    ASSERT_TRUE(late.ended());
    EXPECT_FALSE(late.paired) << "even with the code";
    EXPECT_TRUE(aboard.vehicle.trust.list().empty());
    EXPECT_TRUE(shore.trust.list().empty());
}

/// Sits between: a tracker to the console, a console to the tracker, and hands on what each says.
struct Between {
    explicit Between(const LinkAddress& tracker) : listener(evil.trust.own().value(), [](auto&) { return true; }, {}) {
        listener.listen(QHostAddress::LocalHost);
        to_tracker.setSslConfiguration(tlsConfiguration(evil.trust.own().value(), QSslSocket::VerifyNone));
        QObject::connect(&listener, &TlsListener::admitted, [this, tracker](QSslSocket* console) {
            to_tracker.connectToHostEncrypted("127.0.0.1", tracker.port);
            QObject::connect(console, &QSslSocket::readyRead,
                             [this, console] { to_tracker.write(console->readAll()); });
            QObject::connect(&to_tracker, &QSslSocket::readyRead,
                             [this, console] { console->write(handed_on += to_tracker.readAll()); });
            to_tracker.write(console->readAll());
        });
    }
    LinkAddress address() const {
        LinkAddress address = anywhere();
        address.port = listener.serverPort();
        return address;
    }
    Machine evil;
    TlsListener listener;
    QSslSocket to_tracker;
    QByteArray handed_on;
};

TEST(Pairing, WhoSitsBetweenGetsNothing) {
    Waiting aboard;
    const Machine shore;
    Between between(aboard.address);
    Try console(aboard.code, shore, between.address());
    ASSERT_TRUE(console.ended());
    EXPECT_FALSE(console.paired);
    EXPECT_FALSE(between.handed_on.isEmpty()) << "the proof has come to the tracker";
    EXPECT_TRUE(shore.trust.list().empty());
    EXPECT_TRUE(aboard.vehicle.trust.list().empty());
}

TEST(Pairing, AFalseTrackerThatSaysYesIsNotBelieved) {
    const Machine fake, shore;
    TlsListener listener(fake.trust.own().value(), [](auto&) { return true; }, {});
    ASSERT_TRUE(listener.listen(QHostAddress::LocalHost));
    QObject::connect(&listener, &TlsListener::admitted, [](QSslSocket* socket) {
        socket->write(QByteArray::fromStdString(pairFrame(PairReply{true, "", std::string(32, 'x'), "vehicle"})));
    });
    LinkAddress address = anywhere();
    address.port = listener.serverPort();
    Try console(PairingCode::make(), shore, address);
    ASSERT_TRUE(console.ended());
    EXPECT_NE(console.reason.indexOf("does not know the code"), -1) << console.reason.toStdString();
    EXPECT_TRUE(shore.trust.list().empty());
}

TEST(Pairing, NonsenseIsNoTry) {
    Waiting aboard;
    const Machine stranger, shore;
    for (const QByteArray& nonsense : {QByteArray("\0\0\0\2\xff\xff", 6), QByteArray("\x7f\xff\xff\xff", 4)}) {
        QSslSocket socket;
        socket.setSslConfiguration(tlsConfiguration(stranger.trust.own().value(), QSslSocket::VerifyNone));
        bool closed = false;
        QObject::connect(&socket, &QSslSocket::disconnected, [&] { closed = true; });
        socket.connectToHostEncrypted("127.0.0.1", aboard.address.port);
        socket.write(nonsense);
        ASSERT_TRUE(becomes([&] { return closed; }));
    }
    Try console(aboard.code, shore, aboard.address);
    ASSERT_TRUE(console.ended());
    EXPECT_TRUE(console.paired) << console.reason.toStdString();
}

TEST(TrustStore, KeepsItsKeyToItselfAndItsPeersOnDisk) {
    const Machine machine;
    const QByteArray own = machine.fingerprint();
    EXPECT_EQ(own.size(), 32);
    EXPECT_EQ(machine.fingerprint(), own) << "made once";
    const QString key = machine.folder.path() + "/link/own.pem";
    EXPECT_FALSE(QFile::permissions(key) & (QFile::ReadGroup | QFile::ReadOther));
    ASSERT_TRUE(QFile::setPermissions(key, QFile::ReadOwner | QFile::ReadOther));
    EXPECT_FALSE(machine.trust.own()) << "others have had it";

    const QByteArray one(32, '\1'), two(32, '\2');
    const auto now = QDateTime::currentDateTimeUtc();
    using Role = TrustStore::Role;
    ASSERT_TRUE(machine.trust.add({Role::Console, one, "shore", now}));
    ASSERT_TRUE(machine.trust.add({Role::Console, one, "ship", now})) << "again, by another name";
    ASSERT_TRUE(machine.trust.add({Role::Tracker, two, "ship", now}));
    EXPECT_FALSE(machine.trust.add({Role::Console, "short", "x", now}));
    EXPECT_EQ(machine.trust.list().size(), 2U);
    EXPECT_FALSE(machine.trust.revoke("ship")) << "which one?";
    EXPECT_FALSE(machine.trust.revoke("shore"));
    ASSERT_TRUE(machine.trust.revoke("01010101"));
    EXPECT_FALSE(machine.trust.isPaired(Role::Console, one));
    EXPECT_TRUE(machine.trust.isPaired(Role::Tracker, two));
    EXPECT_FALSE(machine.trust.isPaired(Role::Tracker, "../own.pem"));
}

}  // namespace
}  // namespace echotrail
