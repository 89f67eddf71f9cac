#include "simulated_device.hpp"

#include "core/simulation/ping_model.hpp"

#include <algorithm>

namespace echotrail {

SimulatedDevice::SimulatedDevice(const Scenario& scenario, std::uint64_t seed, const SimulatedHeadOptions& head,
                                 std::unique_ptr<ByteServer> sonar)
    : scenario_(scenario),
      seed_(seed),
      sonar_(std::move(sonar)),
      head_(head,
            [this](const HeadSetup& setup, Microseconds at, std::uint64_t number) { return hear(setup, at, number); }) {
}

void SimulatedDevice::start() {
    deadline_.setSingleShot(true);
    deadline_.setTimerType(Qt::PreciseTimer);
    connect(&deadline_, &QTimer::timeout, this, [this] { move(); });
    connect(sonar_.get(), &ByteServer::received, this, [this](const QByteArray& bytes) {
        head_.received(
            now(), {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
        move();
    });
    head_.powerUp(now());
    move();
}

std::vector<std::uint8_t> SimulatedDevice::hear(const HeadSetup& setup, Microseconds at, std::uint64_t number) {
    if (!first_transmission_) first_transmission_ = at;
    const double time_s = std::chrono::duration<double>(at - *first_transmission_).count();
    return simulateEcho(scenario_, seed_, setup, time_s, number);
}

/// Does what is due, hands over what is through the line, and comes back in time for the next.
void SimulatedDevice::move() {
    head_.tick(now());
    for (const TimedBytes& piece : head_.takeOutput(now()))
        sonar_->send(
            QByteArray(reinterpret_cast<const char*>(piece.bytes.data()), static_cast<int>(piece.bytes.size())));
    if (const auto at = head_.deadline())
        deadline_.start(
            std::max(std::chrono::ceil<std::chrono::milliseconds>(*at - now()), std::chrono::milliseconds(0)));
}

Microseconds SimulatedDevice::now() const {
    return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
}

}  // namespace echotrail
