#pragma once

#include "app/io/byte_server.hpp"
#include "core/simulation/link_faults.hpp"
#include "core/simulation/nmea_output.hpp"
#include "core/simulation/scenario.hpp"
#include "core/simulation/simulated_head.hpp"

#include <QObject>
#include <QTimer>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace echotrail {

/// A scenario acted out: a head on a port that speaks the real protocol and hears the scenario, over a link with
/// faults, and the vehicle's navigation on another port. The scenario begins with the head's first transmission, so
/// that nothing is missed while someone connects; until then navigation says where the vehicle waits.
class SimulatedDevice : public QObject {
public:
    struct Setup {
        Scenario scenario;
        std::uint64_t seed = 0;
        SimulatedHeadOptions head;
        LinkFaultParams faults;
    };
    /// Without `navigation` nothing is said of it.
    SimulatedDevice(const Setup& setup, std::unique_ptr<ByteServer> sonar, std::unique_ptr<ByteServer> navigation);

    void start();
    std::uint64_t transmissions() const { return head_.transmissions(); }
    const std::map<std::string, std::uint64_t>& ignored() const { return head_.ignored(); }
    const std::map<std::string, std::uint64_t>& faults() const { return faults_.counts(); }

private:
    std::vector<std::uint8_t> hear(const HeadSetup& setup, Microseconds at, std::uint64_t number);
    void move();
    void happen(const LinkHappening& happening);
    void sayNavigation();
    Microseconds now() const;

    Setup setup_;
    std::unique_ptr<ByteServer> sonar_, navigation_;
    SimulatedHead head_;
    LinkFaults faults_;
    std::optional<NmeaOutput> nmea_;
    std::optional<Microseconds> first_transmission_;
    QTimer deadline_, navigation_timer_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace echotrail
