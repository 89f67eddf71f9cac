#include "core/simulation/nmea_output.hpp"

#include "core/navigation/nmea.hpp"
#include "core/navigation/nmea_fields.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace echotrail {

using namespace std::chrono_literals;

namespace {

constexpr double knots_per_mps = 3600.0 / 1852.0;
constexpr Microseconds quick = 100ms, slow = 1s;

struct LatitudeLongitude {
    double latitude_rad = 0.0, longitude_rad = 0.0;
};

/// The point of the ellipsoid over a place in the plane that touches it at the origin. It lies below that plane by
/// what the earth curves away, d²/2R along either axis; from there by earth-centred coordinates (geodetic conversion
/// at height 0).
LatitudeLongitude onEarth(const Pose& pose, const SimulatedPlace& place) {
    constexpr double equatorial_radius_m = 6378137.0, flattening = 1.0 / 298.257223563;
    constexpr double eccentricity_squared = flattening * (2.0 - flattening);
    const double latitude = radiansFromDegrees(place.latitude_deg), longitude = radiansFromDegrees(place.longitude_deg);
    const double s = std::sin(latitude), c = std::cos(latitude);
    const double normal_m = equatorial_radius_m / std::sqrt(1.0 - eccentricity_squared * s * s);
    const double meridian_m = normal_m * (1.0 - eccentricity_squared) / (1.0 - eccentricity_squared * s * s);
    const double north = pose.north_m, east = pose.east_m;
    const double up = -(north * north / meridian_m + east * east / normal_m) / 2.0;
    const double outward = normal_m * c - north * s + up * c;
    const double above_equator = normal_m * (1.0 - eccentricity_squared) * s + north * c + up * s;
    const double from_axis = std::hypot(outward, east);
    return {std::atan2(above_equator, from_axis * (1.0 - eccentricity_squared)),
            wrapRadians(longitude + std::atan2(east, outward))};
}

/// `ahead,starboard,A`.
std::string alongVehicle(const Eigen::Vector2d& velocity_mps, Bearing heading) {
    const double c = std::cos(heading.inRadians()), s = std::sin(heading.inRadians());
    const double ahead = velocity_mps.x() * c + velocity_mps.y() * s;
    const double starboard = velocity_mps.y() * c - velocity_mps.x() * s;
    return nmeaNumber(ahead * knots_per_mps, 3) + ',' + nmeaNumber(starboard * knots_per_mps, 3) + ",A";
}

}  // namespace

std::string headingSentence(const NavigationSample& sample) {
    constexpr double hundredths_of_turn = 36'000.0;
    const double hundredths = std::round(sample.pose.heading.inDegrees() * 100.0);
    const double heading = std::fmod(hundredths + hundredths_of_turn, hundredths_of_turn) / 100.0;
    return nmeaSentence("HEHDT," + nmeaNumber(heading, 2) + ",T");
}

std::string speedSentence(const NavigationSample& sample) {
    return nmeaSentence("VDVBW," + alongVehicle(sample.through_water_mps, sample.pose.heading) + ',' +
                        alongVehicle(sample.over_ground_mps, sample.pose.heading));
}

std::string positionSentence(const NavigationSample& sample, Timestamp utc, const SimulatedPlace& place) {
    const LatitudeLongitude at = onEarth(sample.pose, place);
    return nmeaSentence("GPGGA," + nmeaTimeOfDay(utc) + ',' + nmeaCoordinate(at.latitude_rad, 2, 'N', 'S') + ',' +
                        nmeaCoordinate(at.longitude_rad, 3, 'E', 'W') + ",1,08,1.0,0.0,M,0.0,M,,");
}

std::string depthSentence(const NavigationSample& sample) {
    return nmeaSentence("SDDPT," + nmeaNumber(std::max(sample.altitude_m, 0.0), 2) + ",0.0");
}

NmeaOutput::NmeaOutput(const Scenario& scenario, std::uint64_t seed, Timestamp start, const SimulatedPlace& place)
    : navigation_(scenario, seed), start_(start), place_(place) {
    static_assert(quick % SimulatedNavigation::interval == Microseconds(0));
}

std::vector<NmeaOutput::Said> NmeaOutput::take(Microseconds now) {
    std::vector<Said> said;
    for (; next_ <= now; next_ += quick) {
        NavigationSample sample = navigation_.next();
        // The fix comes first: what a reader reckons from the speed of the same moment begins there.
        Said line{next_, next_ % slow == Microseconds(0) ? positionSentence(sample, start_ + next_, place_) : ""};
        line.text += headingSentence(sample) + speedSentence(sample);
        if (next_ % slow == Microseconds(0)) line.text += depthSentence(sample);
        said.push_back(std::move(line));
        // The samples between are not said.
        for (int i = 1; i < quick / SimulatedNavigation::interval; ++i) sample = navigation_.next();
    }
    return said;
}

}  // namespace echotrail
