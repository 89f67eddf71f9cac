#include "live_connection.hpp"

#include "app/io/recording_path.hpp"

#include <QSerialPortInfo>

namespace echotrail {
namespace {

Result<std::unique_ptr<LogWriter>> makeLog(const LiveRequest& request) {
    const auto path = newRecordingPath();
    if (!path) return Error{path.error() + "; connect without recording"};
    const LogHeader header{ECHOTRAIL_VERSION, request.sonar.toStdString(), parameterText(request.params), request.seed,
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

Result<std::unique_ptr<LiveSource>> LiveConnection::make(const LiveRequest& request) {
    auto sonar = parseLinkAddress(request.sonar.toStdString());
    if (!sonar) return Error{sonar.error()};
    std::optional<LinkAddress> navigation;
    if (!request.navigation.isEmpty()) {
        auto parsed = parseLinkAddress(request.navigation.toStdString());
        if (!parsed) return Error{"navigation: " + parsed.error()};
        navigation = *std::move(parsed);
    }
    std::unique_ptr<LogWriter> log;
    if (request.record) {
        auto made = makeLog(request);
        if (!made) return Error{made.error()};
        log = *std::move(made);
    }
    return std::unique_ptr<LiveSource>(
        std::make_unique<LiveConnection>(*sonar, navigation, request.params, request.seed, std::move(log)));
}

LiveConnection::LiveConnection(const LinkAddress& sonar, const std::optional<LinkAddress>& navigation,
                               const LiveRunner::Params& params, std::uint64_t seed, std::unique_ptr<LogWriter> log)
    : runner_(params, seed, std::move(log)), link_(sonar, navigation, params.head, runner_) {
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
