#pragma once

#include "core/simulation/link_faults.hpp"
#include "core/simulation/nmea_output.hpp"
#include "core/simulation/pursuing_vehicle.hpp"
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
        std::optional<PursuitParams> pursuit;  ///< the vehicle is steered by the reports it hears
    };
    explicit SimulatedDevice(const Setup& setup);
    ~SimulatedDevice() override;

    /// Powers the head up.
    void start();
    /// What its host sends.
    void receive(const QByteArray& bytes);
    /// What the tracker reports of its target, for a vehicle that is steered by it: whole lines or pieces of them. What
    /// is none is counted.
    void receiveReports(const QByteArray& bytes);
    /// Seconds since the scenario began; nothing before the head's first transmission.
    std::optional<double> scenarioTime() const;
    /// As it is acted out, with the vehicle that is steered.
    const Scenario& scenario() const { return setup_.scenario; }
    /// Moved on to now; nothing where the vehicle goes its scenario's way.
    const PursuingVehicle* pursuer();
    std::uint64_t transmissions() const { return head_.transmissions(); }
    const std::map<std::string, std::uint64_t>& ignored() const { return head_.ignored(); }
    const std::map<std::string, std::uint64_t>& faults() const { return faults_.counts(); }
    std::uint64_t badReports() const { return bad_reports_; }

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
    void hearReport(const QByteArray& line);
    Microseconds now() const;

    Setup setup_;
    std::optional<PursuingVehicle> pursuer_;
    QByteArray report_begun_;
    std::uint64_t bad_reports_ = 0;
    SimulatedHead head_;
    LinkFaults faults_;
    std::unique_ptr<EchoModel> echoes_;
    std::optional<NmeaOutput> nmea_;
    std::optional<Microseconds> first_transmission_;
    QTimer deadline_{this}, navigation_timer_{this};
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace echotrail
