#include "app/io/simulated_device.hpp"

#include "core/simulation/echo_model.hpp"

#include <algorithm>

namespace echotrail {

namespace {

constexpr int navigation_interval_ms = 50;
constexpr qsizetype longest_report = 4096;

QByteArray toQt(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size())};
}

Timestamp utcNow() { return std::chrono::time_point_cast<Microseconds>(std::chrono::system_clock::now()); }

}  // namespace

SimulatedDevice::SimulatedDevice(const Setup& setup)
    : setup_(setup),
      head_(setup.head,
            [this](const HeadSetup& head, Microseconds at, std::uint64_t number) { return hear(head, at, number); }),
      faults_(setup.faults, setup.seed) {
    if (setup_.pursuit) {
        pursuer_.emplace(*setup_.pursuit, setup_.scenario);
        setup_.scenario.vehicle.steered = pursuer_->path();
    }
    echoes_ = std::make_unique<EchoModel>(setup_.scenario, setup_.seed);
}

SimulatedDevice::~SimulatedDevice() = default;

void SimulatedDevice::start() {
    deadline_.setSingleShot(true);
    deadline_.setTimerType(Qt::PreciseTimer);
    connect(&deadline_, &QTimer::timeout, this, [this] { move(); });
    navigation_timer_.setTimerType(Qt::PreciseTimer);
    connect(&navigation_timer_, &QTimer::timeout, this, [this] { sayNavigation(); });
    navigation_timer_.start(navigation_interval_ms);
    head_.powerUp(now());
    move();
}

void SimulatedDevice::receive(const QByteArray& bytes) {
    if (!faults_.down())
        head_.received(
            now(), {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
    move();
}

std::vector<std::uint8_t> SimulatedDevice::hear(const HeadSetup& head, Microseconds at, std::uint64_t number) {
    if (!first_transmission_) first_transmission_ = at;
    const double time_s = std::chrono::duration<double>(at - *first_transmission_).count();
    if (pursuer_) pursuer_->moveTo(time_s);
    return echoes_->echo(head, time_s, number);
}

/// Does what is due, hands over what is through the line, and comes back in time for the next.
void SimulatedDevice::move() {
    head_.tick(now());
    for (const TimedBytes& piece : head_.takeOutput(now())) faults_.send(piece.at, piece.bytes);
    faults_.tick(now());
    for (const LinkHappening& happening : faults_.takeOutput(now())) happen(happening);
    auto next = head_.deadline();
    if (const auto fault = faults_.deadline(); fault && (!next || *fault < *next)) next = fault;
    if (next)
        deadline_.start(
            std::max(std::chrono::ceil<std::chrono::milliseconds>(*next - now()), std::chrono::milliseconds(0)));
}

void SimulatedDevice::happen(const LinkHappening& happening) {
    switch (happening.kind) {
        case LinkHappening::Kind::Read:
            Q_EMIT sonarSaid(toQt(happening.bytes));
            break;
        case LinkHappening::Kind::Down:
            Q_EMIT linkBroke();
            break;
        case LinkHappening::Kind::Up:
            break;  // whoever asks is let in again
        case LinkHappening::Kind::Reboot:
            head_.powerUp(now());
            break;
    }
}

void SimulatedDevice::sayNavigation() {
    if (!first_transmission_) {
        // The vehicle waits where the scenario begins.
        const NavigationSample waiting = SimulatedNavigation(setup_.scenario, setup_.seed).next();
        NavigationSample still = waiting;
        still.over_ground_mps = still.through_water_mps = {0.0, 0.0};
        const std::string text = headingSentence(still) + positionSentence(still, utcNow(), {});
        Q_EMIT navigationSaid(QByteArray::fromStdString(text));
        return;
    }
    const Microseconds since = now() - *first_transmission_;
    if (pursuer_) pursuer_->moveTo(std::chrono::duration<double>(since).count());
    if (!nmea_) nmea_.emplace(setup_.scenario, setup_.seed, utcNow() - since);
    for (const NmeaOutput::Said& said : nmea_->take(since)) Q_EMIT navigationSaid(QByteArray::fromStdString(said.text));
}

void SimulatedDevice::receiveReports(const QByteArray& bytes) {
    report_begun_ += bytes;
    for (qsizetype end = report_begun_.indexOf('\n'); end >= 0; end = report_begun_.indexOf('\n')) {
        hearReport(report_begun_.left(end));
        report_begun_.remove(0, end + 1);
    }
    if (report_begun_.size() <= longest_report) return;
    report_begun_.clear();
    ++bad_reports_;
}

void SimulatedDevice::hearReport(const QByteArray& line) {
    const auto report = readSteeringReport({line.constData(), static_cast<std::size_t>(line.size())});
    if (!report) {
        ++bad_reports_;
        return;
    }
    const auto time_s = scenarioTime();
    if (!pursuer_ || !time_s) return;
    pursuer_->moveTo(*time_s);
    pursuer_->hear(*report, *time_s);
}

std::optional<double> SimulatedDevice::scenarioTime() const {
    if (!first_transmission_) return std::nullopt;
    return std::chrono::duration<double>(now() - *first_transmission_).count();
}

const PursuingVehicle* SimulatedDevice::pursuer() {
    if (!pursuer_) return nullptr;
    if (const auto time_s = scenarioTime()) pursuer_->moveTo(*time_s);
    return &*pursuer_;
}

Microseconds SimulatedDevice::now() const {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
}

}  // namespace echotrail
