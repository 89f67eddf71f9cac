#pragma once

#include "app/io/byte_server.hpp"
#include "core/simulation/scenario.hpp"
#include "core/simulation/simulated_head.hpp"

#include <QObject>
#include <QTimer>
#include <chrono>
#include <memory>
#include <optional>

namespace echotrail {

/// A scenario acted out: a head on a port that speaks the real protocol and hears the scenario. The scenario begins
/// with the head's first transmission, so that nothing is missed while someone connects.
class SimulatedDevice : public QObject {
public:
    SimulatedDevice(const Scenario& scenario, std::uint64_t seed, const SimulatedHeadOptions& head,
                    std::unique_ptr<ByteServer> sonar);

    void start();
    std::uint64_t transmissions() const { return head_.transmissions(); }
    const std::map<std::string, std::uint64_t>& ignored() const { return head_.ignored(); }

private:
    std::vector<std::uint8_t> hear(const HeadSetup& setup, Microseconds at, std::uint64_t number);
    void move();
    Microseconds now() const;

    Scenario scenario_;
    std::uint64_t seed_;
    std::unique_ptr<ByteServer> sonar_;
    SimulatedHead head_;
    std::optional<Microseconds> first_transmission_;
    QTimer deadline_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace echotrail
