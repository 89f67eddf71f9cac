#include "live_connection.hpp"

#include "app/io/recording_path.hpp"
#include "remote_connection.hpp"

#include <QSerialPortInfo>

namespace echotrail {
namespace {

Result<std::unique_ptr<LogWriter>> makeLog(const LiveRequest& request, const std::string& source) {
    const auto path = newRecordingPath();
    if (!path) return Error{path.error() + "; connect without recording"};
    const LogHeader header{ECHOTRAIL_VERSION, source, parameterText(request.params), request.seed,
                           std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now())};
    return LogWriter::create(*path, header);
}

LiveLink shown(const LinkState& link) {
    LiveLink state{link.up, QString::fromStdString(link.reason), {}};
    if (link.last_bytes)
        state.age_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - *link.last_bytes).count();
    return state;
}

}  // namespace

QStringList serialPorts() {
    QStringList addresses;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts())
        addresses << "serial://" + port.systemLocation();
    return addresses;
}

LiveAccess liveAccess() {
    LiveAccess access{LiveConnection::make, serialPorts, {}, {}, {}};
    for (const Scenario& scenario : scenarios())
        access.simulated_heads.append({QString::fromStdString(scenario.name),
                                       QString::fromStdString("simulation://" + scenario.name),
                                       QString::fromStdString(scenario.description)});
    access.open_tracker = RemoteConnection::make;
    access.recordings = QString::fromStdString(recordingsFolder());
    return access;
}

Result<std::unique_ptr<LiveSource>> LiveConnection::make(const LiveRequest& request) {
    const auto addresses = parseLiveAddresses(request.sonar.toStdString(), request.navigation.toStdString());
    if (!addresses) return Error{addresses.error()};
    std::unique_ptr<LogWriter> log;
    if (request.record) {
        auto made = makeLog(request, addresses->sonarText());
        if (!made) return Error{made.error()};
        log = *std::move(made);
    }
    return std::unique_ptr<LiveSource>(
        std::make_unique<LiveConnection>(*addresses, request.params, request.seed, std::move(log)));
}

LiveConnection::LiveConnection(const LiveAddresses& addresses, const LiveRunner::Params& params, std::uint64_t seed,
                               std::unique_ptr<LogWriter> log)
    : runner_(params, seed, std::move(log)), link_(addresses, params.head, runner_) {
    thread_.setObjectName("head link");
    link_.moveToThread(&thread_);
}

LiveConnection::~LiveConnection() {
    if (!thread_.isRunning()) return;
    QMetaObject::invokeMethod(
        &link_, [this] { link_.close(); }, Qt::BlockingQueuedConnection);
    thread_.quit();
    thread_.wait();
}

void LiveConnection::start() {
    thread_.start();
    QMetaObject::invokeMethod(&link_, [this] { link_.open(); });
}

void LiveConnection::setParams(const LiveRunner::Params& params) {
    runner_.setParams(params);
    QMetaObject::invokeMethod(&link_, [this, head = params.head] { link_.setSettings(head); });
}

LiveState LiveConnection::state() const {
    const HeadLinkState link = link_.state();
    LiveState state{.sonar = shown(link.sonar), .head = link.head, .run = runner_.status()};
    if (link.navigation) state.navigation = shown(*link.navigation);
    const Timestamp now = runner_.now();
    if (state.run.last_ping) state.ping_age_s = secondsBetween(*state.run.last_ping, now);
    if (const auto heading = state.run.navigation.heading_time) state.heading_age_s = secondsBetween(*heading, now);
    return state;
}

}  // namespace echotrail
