#include "core/tracking/track_text.hpp"

#include <cassert>
#include <cmath>

namespace echotrail {

namespace {

/// Micrometres and microdegrees are finer than any sonar; all digits of a double only make the lines long.
double rounded(double value, double digits = 1e6) {
    assert(std::isfinite(value));
    return std::round(value * digits) / digits + 0.0;  // + 0.0: no "-0.0"
}

}  // namespace

nlohmann::ordered_json trackLine(const TrackLook& look, Timestamp first_ping) {
    constexpr double covariance_digits = 1e9;
    const Eigen::Matrix2d& c = look.covariance_m2;
    return {{"time", toIso8601(look.time)},
            {"t", rounded(secondsBetween(first_ping, look.time))},
            {"track", look.track},
            {"state", toText(look.state)},
            {"target", look.target},
            {"range_m", rounded(look.range_m)},
            {"bearing_deg", rounded(look.bearing.inDegrees())},
            {"north_m", rounded(look.position_m.x())},
            {"east_m", rounded(look.position_m.y())},
            {"velocity_north_mps", rounded(look.velocity_mps.x())},
            {"velocity_east_mps", rounded(look.velocity_mps.y())},
            {"covariance_m2",
             {rounded(c(0, 0), covariance_digits), rounded(c(0, 1), covariance_digits),
              rounded(c(1, 1), covariance_digits)}},
            {"seen", look.seen},
            {"cause", toText(look.no_echo)}};
}

nlohmann::ordered_json reportLine(const TargetReport& report, Timestamp first_ping) {
    auto line = trackLine(report.look, first_ping);
    line["age_s"] = report.age_s;
    line["valid"] = report.valid;
    line["closest_approach_m"] = report.closest_approach_m;
    line["time_to_closest_s"] = report.time_to_closest_s;
    line["risk"] = report.risk;
    return line;
}

}  // namespace echotrail
