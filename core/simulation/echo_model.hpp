#pragma once

#include "core/simulation/acoustics.hpp"
#include "core/simulation/ground.hpp"
#include "core/simulation/head_setup.hpp"
#include "core/simulation/objects.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace echotrail {

/// What a head hears in a scenario, transmission by transmission (method card, section i). An echo depends on nothing
/// but the scenario, the seed and the arguments of that call: transmissions can be made in any order, by one model or
/// by many. What is the same for many of them is kept, as it costs more to make than the rest.
/// State: that memory only.
class EchoModel {
public:
    EchoModel(const Scenario& scenario, std::uint64_t seed);
    EchoModel(const EchoModel&) = delete;  // its parts know where it is
    EchoModel& operator=(const EchoModel&) = delete;

    /// As simulateEcho().
    std::vector<std::uint8_t> echo(const HeadSetup& head, double time_s, std::uint64_t number);

private:
    /// What depends on a bin's range and on the head alone. Powers relative to 1, levels in dB.
    struct RangeTable {
        std::vector<double> range_m, surface, volume, noise, uncompensated_db, ring_db;
    };
    void layTable(const HeadSetup& head);
    void layBottom(double altitude_m);
    void addBottom(const HeadSetup& head, const VehicleState& vehicle, const ObjectEchoes& objects);
    void addObjects(const ObjectEchoes& objects);

    Scenario scenario_;
    std::uint64_t seed_;
    std::vector<Debris> debris_;
    GroundMemory ground_;
    std::optional<HeadSetup> head_;  ///< that the table is of
    acoustics::Lobe lobe_;
    RangeTable table_;
    double altitude_m_ = -1.0;         ///< that `bottom_` is of
    std::vector<double> bottom_;       ///< power of a bottom of mean strength, by bin
    std::vector<double> bottom_here_;  ///< of the present transmission
    std::vector<double> objects_here_;
};

}  // namespace echotrail
