#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"
#include "core/simulation/commanded_scan.hpp"
#include "core/simulation/echo_model.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace echotrail {

/// Where a target truly was when a ping was transmitted.
struct TruthSample {
    Timestamp time{};      ///< of the ping
    int target = 0;        ///< its place in Scenario::targets
    double north_m = 0.0;  ///< local frame
    double east_m = 0.0;
    double velocity_north_mps = 0.0;
    double velocity_east_mps = 0.0;
    double range_m = 0.0;  ///< from the head
    Bearing from_bow;
    bool in_beam = false;  ///< this ping's lobe is on it
    bool visible = false;  ///< inside the scanned sector and range, whatever way the beam looks just now
};

/// A scenario, ping by ping, with the navigation that belongs to it. The same scenario and seed give the same bytes.
class SimulatedSource final : public PingSource {
public:
    SimulatedSource(Scenario scenario, std::uint64_t seed);

    std::optional<Ping> next() override;
    void rewind() override;
    /// What the head is to scan from here on, until rewind(); as CommandedScan takes it. Truth and info() stay those of
    /// the scenario's own scan.
    void command(const ScanSector& sector);
    /// From here on every ping is kept for the next time round: making one costs more than following targets in it.
    /// About 30 MB for an hour.
    void keepPings() { keep_ = true; }
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override { return {}; }
    /// The vehicle's poses as its navigation tells them, one every 50 ms, until the last echo has come back.
    const PoseHistory& navigation() const override { return navigation_; }

    const Scenario& scenario() const { return scenario_; }
    /// For every ping, each target in turn.
    std::vector<TruthSample> truth() const;

private:
    std::optional<Ping> nextCommanded();

    Scenario scenario_;
    std::uint64_t seed_;
    std::uint64_t next_ = 0;
    bool keep_ = false;
    std::vector<Ping> kept_;             ///< the first ones
    std::optional<CommandedScan> scan_;  ///< of a head that has been commanded
    std::uint64_t given_ = 0;            ///< by that one
    SourceInfo info_;
    PoseHistory navigation_;
    EchoModel model_;
};

/// A built-in scenario by its name; "demo" is the demonstration. The error names them all.
Result<Scenario> findScenario(std::string_view name);
/// The same as a source of pings.
Result<std::unique_ptr<SimulatedSource>> openSimulation(std::string_view name, std::uint64_t seed);

}  // namespace echotrail
