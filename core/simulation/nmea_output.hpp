#pragma once

#include "core/base/parameters.hpp"
#include "core/base/time.hpp"
#include "core/simulation/simulated_navigation.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace echotrail {

/// Where on earth the scenario's local frame lies: its origin on the WGS-84 ellipsoid.
struct SimulatedPlace {
    double latitude_deg = 60.4;
    double longitude_deg = 5.3;
};

template <>
struct Described<SimulatedPlace> {
    static constexpr std::string_view group = "Place of a simulation";
    static constexpr auto fields = std::tuple{Field{&SimulatedPlace::latitude_deg, "origin_latitude_deg", "deg", -80,
                                                    80, "Latitude of the scenario's origin, north positive"},
                                              Field{&SimulatedPlace::longitude_deg, "origin_longitude_deg", "deg", -180,
                                                    180, "Longitude of the scenario's origin, east positive"}};
};

/// Sentences of NMEA 0183 (version 4.10) with their checksum and end of line. What the instruments of `sample` err by
/// is in it already.
/// HDT: heading from true north.
std::string headingSentence(const NavigationSample& sample);
/// VBW: speeds ahead and to starboard through water and over ground.
std::string speedSentence(const NavigationSample& sample);
/// GGA: the position of the pose; `utc` gives the time of day. Exact to 1 cm within 10 km of the origin.
std::string positionSentence(const NavigationSample& sample, Timestamp utc, const SimulatedPlace& place);
/// DPT: water below the head.
std::string depthSentence(const NavigationSample& sample);

/// What the vehicle's navigation says on its line, sentence by sentence: HDT and VBW ten times a second, GGA and DPT
/// once. The same scenario and seed say the same. State: how far it has got.
class NmeaOutput {
public:
    struct Said {
        Microseconds at{};  ///< since the scenario's start
        std::string text;   ///< whole lines
    };

    /// `start`: the UTC of the scenario's start.
    NmeaOutput(const Scenario& scenario, std::uint64_t seed, Timestamp start, const SimulatedPlace& place = {});
    /// What is said until `now`, and was not given before.
    std::vector<Said> take(Microseconds now);
    /// When the next one is said.
    Microseconds deadline() const { return next_; }

private:
    SimulatedNavigation navigation_;
    Timestamp start_;
    SimulatedPlace place_;
    Microseconds next_{};
};

}  // namespace echotrail
