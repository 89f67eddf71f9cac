#pragma once

#include "core/simulation/link_faults.hpp"
#include "core/simulation/nmea_output.hpp"
#include "core/simulation/scenario.hpp"
#include "core/simulation/simulated_head.hpp"

#include <QByteArray>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace echotrail {

class EchoModel;

/// A scenario acted out by the clock: a head that speaks the real protocol and hears the scenario, over a link with
/// faults, and the vehicle's navigation. The scenario begins with the head's first transmission, so that nothing is
/// missed while someone connects; until then navigation says where the vehicle waits.
/// Threads: the one it lives in, whose event loop runs.
class SimulatedDevice : public QObject {
    Q_OBJECT
public:
    struct Setup {
        Scenario scenario;
        std::uint64_t seed = 0;
        SimulatedHeadOptions head;
        LinkFaultParams faults;
    };
    explicit SimulatedDevice(const Setup& setup);
    ~SimulatedDevice() override;

    /// Powers the head up.
    void start();
    /// What its host sends.
    void receive(const QByteArray& bytes);
    std::uint64_t transmissions() const { return head_.transmissions(); }
    const std::map<std::string, std::uint64_t>& ignored() const { return head_.ignored(); }
    const std::map<std::string, std::uint64_t>& faults() const { return faults_.counts(); }

Q_SIGNALS:
    /// What came through the head's line.
    void sonarSaid(const QByteArray& bytes);
    /// The link is to break, as by a pulled cable; whoever asks is let in again.
    void linkBroke();
    void navigationSaid(const QByteArray& lines);

private:
    std::vector<std::uint8_t> hear(const HeadSetup& setup, Microseconds at, std::uint64_t number);
    void move();
    void happen(const LinkHappening& happening);
    void sayNavigation();
    Microseconds now() const;

    Setup setup_;
    SimulatedHead head_;
    LinkFaults faults_;
    std::unique_ptr<EchoModel> echoes_;
    std::optional<NmeaOutput> nmea_;
    std::optional<Microseconds> first_transmission_;
    QTimer deadline_{this}, navigation_timer_{this};
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace echotrail
