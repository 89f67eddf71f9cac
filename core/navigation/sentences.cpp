#include "core/navigation/sentences.hpp"

#include <charconv>
#include <cmath>
#include <optional>

namespace echotrail {
namespace {

constexpr double metres_per_second_of_knot = 1852.0 / 3600.0;
constexpr double fastest_knots = 200.0;  // faster than anything afloat: a damaged number

Error rejected(std::string_view cause) { return Error{std::string(cause)}; }

/// A whole field as a number within limits.
std::optional<double> number(std::string_view text, double minimum, double maximum) {
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    // Written so that "nan", which from_chars takes, is outside.
    if (!(value >= minimum && value <= maximum)) return std::nullopt;
    return value;
}

/// An angle in degrees and the letter of its side; 0 where both are empty, as an instrument leaves what it lacks.
std::optional<double> signedDegrees(std::string_view size, std::string_view side) {
    if (size.empty() && side.empty()) return 0.0;
    const auto value = number(size, 0.0, 180.0);
    if (!value || (side != "E" && side != "W")) return std::nullopt;
    return side == "E" ? *value : -*value;
}

/// `dddmm.mmmm` and the letter of its hemisphere, in radians.
std::optional<double> coordinate(std::string_view text, std::string_view side, char positive, char negative,
                                 double limit_deg) {
    const auto value = number(text, 0.0, limit_deg * 100.0);
    if (!value || side.size() != 1 || (side[0] != positive && side[0] != negative)) return std::nullopt;
    const double degrees = std::floor(*value / 100.0);
    const double minutes = *value - degrees * 100.0;
    if (minutes >= 60.0) return std::nullopt;
    const double radians = radiansFromDegrees(degrees + minutes / 60.0);
    return side[0] == positive ? radians : -radians;
}

/// VTG: course true,T,course magnetic,M,knots,N,km/h,K[,mode].
Result<GroundVelocity> readCourseAndSpeed(const NmeaSentence& sentence) {
    if (sentence.field(8) == "N") return rejected(nmea_cause::not_valid);
    const auto knots = number(sentence.field(4), 0.0, fastest_knots);
    if (!knots || sentence.field(5) != "N") return rejected(nmea_cause::bad_field);
    // Receivers leave the course empty while they stand still.
    if (*knots == 0.0) return GroundVelocity{};
    const auto course = number(sentence.field(0), 0.0, 360.0);
    if (!course || sentence.field(1) != "T") return rejected(nmea_cause::bad_field);
    const double speed = *knots * metres_per_second_of_knot;
    const double angle = radiansFromDegrees(*course);
    return GroundVelocity{speed * std::cos(angle), speed * std::sin(angle), false};
}

}  // namespace

Result<HeadingReading> readHeading(const NmeaSentence& sentence) {
    const auto heading = number(sentence.field(0), 0.0, 360.0);
    if (!heading) return rejected(nmea_cause::bad_field);
    if (sentence.id == "HDT") return HeadingReading{Bearing::degrees(*heading), false};
    const auto deviation = signedDegrees(sentence.field(1), sentence.field(2));
    const auto variation = signedDegrees(sentence.field(3), sentence.field(4));
    if (!deviation || !variation) return rejected(nmea_cause::bad_field);
    return HeadingReading{Bearing::degrees(*heading + *deviation + *variation), sentence.field(3).empty()};
}

Result<GeographicPosition> readPosition(const NmeaSentence& sentence) {
    const bool is_rmc = sentence.id == "RMC";
    // RMC: time, status A or V, position…; GGA: time, position, quality 0 (no fix) to 8…
    const std::string_view validity = is_rmc ? sentence.field(1) : sentence.field(5);
    if (validity == (is_rmc ? "V" : "0")) return rejected(nmea_cause::not_valid);
    const bool known = is_rmc ? validity == "A" : number(validity, 1.0, 8.0).has_value();
    const std::size_t first = is_rmc ? 2 : 1;
    const auto latitude = coordinate(sentence.field(first), sentence.field(first + 1), 'N', 'S', 90.0);
    const auto longitude = coordinate(sentence.field(first + 2), sentence.field(first + 3), 'E', 'W', 180.0);
    if (!known || !latitude || !longitude) return rejected(nmea_cause::bad_field);
    return GeographicPosition{*latitude, *longitude};
}

Result<GroundVelocity> readVelocity(const NmeaSentence& sentence) {
    if (sentence.id == "VTG") return readCourseAndSpeed(sentence);
    // VBW: ahead and starboard through water, status, ahead and starboard over ground, status; all in knots.
    if (sentence.field(5) == "V") return rejected(nmea_cause::not_valid);
    const auto ahead = number(sentence.field(3), -fastest_knots, fastest_knots);
    const auto starboard = number(sentence.field(4), -fastest_knots, fastest_knots);
    if (!ahead || !starboard || sentence.field(5) != "A") return rejected(nmea_cause::bad_field);
    return GroundVelocity{*ahead * metres_per_second_of_knot, *starboard * metres_per_second_of_knot, true};
}

Result<double> readDepth(const NmeaSentence& sentence) {
    // DPT: depth in metres, offset of the transducer…; DBT: feet,f,metres,M,fathoms,F.
    const bool dbt = sentence.id == "DBT";
    const auto metres = number(sentence.field(dbt ? 2 : 0), 0.0, 12'000.0);
    if (!metres || (dbt && sentence.field(3) != "M")) return rejected(nmea_cause::bad_field);
    return *metres;
}

}  // namespace echotrail
