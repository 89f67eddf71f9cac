#include "core/navigation/target_sentences.hpp"

#include "core/navigation/nmea.hpp"
#include "core/navigation/nmea_fields.hpp"

#include <cmath>
#include <cstdio>

namespace echotrail {

namespace {

char statusOf(TrackState state) { return state == TrackState::Lost ? 'L' : state == TrackState::Confirmed ? 'T' : 'Q'; }

}  // namespace

std::string ttmSentence(const TrackLook& look, double closest_approach_m, double time_to_closest_s) {
    const double metres_per_km = 1000.0;
    const double speed_kmh = look.velocity_mps.norm() * 3.6;
    const auto turn = [](double degrees) { return degrees < 0.0 ? degrees + 360.0 : degrees; };
    const double course = turn(degreesFromRadians(std::atan2(look.velocity_mps.y(), look.velocity_mps.x())));
    char body[128];
    std::snprintf(body, sizeof body, "RATTM,%02d,%.4f,%.1f,R,%.2f,%.1f,T,%.4f,%.3f,K,,%c,,", look.track % 100,
                  look.range_m / metres_per_km, turn(look.bearing.inDegrees()), speed_kmh, course,
                  closest_approach_m / metres_per_km, time_to_closest_s / 60.0, statusOf(look.state));
    return nmeaSentence(body);
}

std::string tllSentence(const TrackLook& look, const GeographicPosition& position) {
    std::string body = "RATLL," + nmeaNumber(look.track % 100, 0, 2) + ',';
    body += nmeaCoordinate(position.latitude_rad, 2, 'N', 'S') + ',';
    body += nmeaCoordinate(position.longitude_rad, 3, 'E', 'W') + ",,";
    body += nmeaTimeOfDay(look.time) + ',';
    body += statusOf(look.state);
    return nmeaSentence(body + ',');
}

}  // namespace echotrail
