#include "app/io/pairing.hpp"
#include "commands.hpp"
#include "event_loop.hpp"

#include <QCoreApplication>
#include <QSysInfo>
#include <iostream>
#include <string>

namespace echotrail {
namespace {

struct PairArguments {
    std::string tracker, serve = "tls://0.0.0.0:7001", revoke, name;
    bool list = false;
};

std::string roleText(const TrustStore::Peer& peer) {
    return peer.role == TrustStore::Role::Console ? "console" : "tracker";
}

std::string beginningOf(const QByteArray& fingerprint) { return fingerprint.toHex().left(16).toStdString(); }

void tellPaired(const TrustStore::Peer& peer) {
    std::cout << "paired with the " << roleText(peer) << " '" << peer.name.toStdString() << "', "
              << beginningOf(peer.fingerprint) << std::endl;
}

ExitCode list(const TrustStore& trust) {
    for (const TrustStore::Peer& peer : trust.list())
        std::cout << roleText(peer) << "  " << beginningOf(peer.fingerprint) << "  "
                  << peer.paired.toString(Qt::ISODate).toStdString() << "  " << peer.name.toStdString() << "\n";
    return ExitCode::Done;
}

ExitCode revoke(const TrustStore& trust, const std::string& whom) {
    const auto peer = trust.revoke(QString::fromStdString(whom));
    if (!peer) return fail(ExitCode::Failed, peer.error());
    std::cout << "the " << roleText(*peer) << " '" << peer->name.toStdString() << "', "
              << beginningOf(peer->fingerprint) << ", is trusted no more\n";
    return ExitCode::Done;
}

/// Aboard: shows a code, and waits.
ExitCode waitForConsole(const TrustStore& trust, const PairArguments& arguments, const QString& name) {
    const auto address = parseLinkAddress(arguments.serve);
    if (!address) return fail(ExitCode::Usage, "--serve: " + address.error());
    const PairingCode code = PairingCode::make();
    PairingServer server(code, trust, name);
    const auto real = server.listen(*address);
    if (!real) return fail(ExitCode::Failed, real.error());
    ExitCode ended = ExitCode::Failed;
    std::string reason = "interrupted; nothing has been paired";
    QObject::connect(&server, &PairingServer::noted,
                     [](const QString& text) { std::cerr << "echotrail: " << text.toStdString() << std::endl; });
    QObject::connect(&server, &PairingServer::over, [&](const QString& why) {
        reason = why.toStdString();
        QCoreApplication::quit();
    });
    QObject::connect(&server, &PairingServer::paired, [&](const TrustStore::Peer& console) {
        tellPaired(console);
        ended = ExitCode::Done;
        QCoreApplication::quit();
    });
    std::cout << "The code is " << code.text() << "; it holds for five minutes, and once.\n"
              << "At the console run: echotrail pair tls://THIS-MACHINE:" << real->port << std::endl;
    runEventLoop(std::nullopt);
    return ended == ExitCode::Done ? ended : fail(ended, reason);
}

/// At the console: asks for the code, and goes there.
ExitCode goToTracker(const TrustStore& trust, const PairArguments& arguments, const QString& name) {
    const auto address = parseLinkAddress(arguments.tracker);
    if (!address || address->kind != LinkAddress::Kind::Tls || address->port == 0)
        return fail(ExitCode::Usage, "'" + arguments.tracker + "' is no address of a tracker; say tls://HOST:PORT");
    std::cout << "The code that 'echotrail pair' shows aboard: " << std::flush;
    std::string typed;
    std::getline(std::cin, typed);
    const auto code = PairingCode::parse(typed);
    if (!code) return fail(ExitCode::Usage, "a code has sixteen letters and digits, as in 7K3M-9QXA-01TB-WZ8E");
    PairingClient client(*code, trust, name);
    ExitCode ended = ExitCode::Failed;
    std::string reason = "interrupted; nothing has been paired";
    QObject::connect(&client, &PairingClient::failed, [&](const QString& why) {
        reason = arguments.tracker + ": " + why.toStdString();
        QCoreApplication::quit();
    });
    QObject::connect(&client, &PairingClient::paired, [&](const TrustStore::Peer& tracker) {
        tellPaired(tracker);
        ended = ExitCode::Done;
        QCoreApplication::quit();
    });
    if (const auto begun = client.begin(*address); !begun) return fail(ExitCode::Failed, begun.error());
    runEventLoop(std::nullopt);
    return ended == ExitCode::Done ? ended : fail(ended, reason);
}

ExitCode pair(const PairArguments& arguments) {
    int argc = 1;
    char program[] = "echotrail";
    char* argv[] = {program, nullptr};
    const QCoreApplication application(argc, argv);
    const TrustStore trust = TrustStore::ofUser();
    if (arguments.list) return list(trust);
    if (!arguments.revoke.empty()) return revoke(trust, arguments.revoke);
    const QString name = arguments.name.empty() ? QSysInfo::machineHostName() : QString::fromStdString(arguments.name);
    if (!arguments.tracker.empty()) return goToTracker(trust, arguments, name);
    return waitForConsole(trust, arguments, name);
}

}  // namespace

Command addPairCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "pair",
        "Make a tracker and a console known to each other. Aboard, without an address: shows a code of one use and "
        "five minutes, and waits. At the console, with the tracker's address: asks for that code. From then on "
        "'track --serve tls://…' lets this console in, and 'echotrail-console --connect tls://…' believes this "
        "tracker.");
    auto arguments = std::make_shared<PairArguments>();
    auto* tracker =
        command->add_option("TRACKER", arguments->tracker, "Where 'echotrail pair' waits aboard: tls://HOST:PORT");
    auto* serve = command->add_option("--serve", arguments->serve, "Aboard: where to wait; port 0 takes any free one")
                      ->capture_default_str()
                      ->excludes(tracker);
    command->add_option("--name", arguments->name, "Of this machine, for the other's list (default: its host name)");
    auto* list = command->add_flag("--list", arguments->list,
                                   "Who is paired with this machine: role, fingerprint, since when, name");
    command
        ->add_option("--revoke", arguments->revoke,
                     "A name or the beginning of a fingerprint of the list: is trusted no more, and dropped at once")
        ->excludes(list)
        ->excludes(tracker)
        ->excludes(serve);
    return [arguments] { return pair(*arguments); };
}

}  // namespace echotrail
