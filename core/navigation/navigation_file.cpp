#include "core/navigation/navigation_file.hpp"

#include "core/navigation/local_plane.hpp"
#include "core/navigation/nmea.hpp"
#include "core/navigation/sentences.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

namespace echotrail {
namespace {

template <class Value>
struct Timed {
    Timestamp time{};
    Value value;
};
template <class Value>
using Series = std::vector<Timed<Value>>;

/// Everything good in a file, one series per kind of sentence.
struct Readings {
    Series<HeadingReading> hdt, hdg;
    Series<GeographicPosition> rmc, gga;
    Series<GroundVelocity> vtg, vbw;
};

constexpr std::streamsize longest_line = 1024;  // ten times what the standard allows

/// The next line; a longer one than any sentence (a file of something else) comes empty and is skipped to its end,
/// so that memory stays bounded.
bool nextLine(std::istream& stream, std::string& line, bool& too_long) {
    line.resize(longest_line);
    stream.getline(line.data(), longest_line);
    const std::streamsize taken = stream.gcount();
    too_long = stream.fail() && taken == longest_line - 1;
    if (too_long) {
        stream.clear();
        stream.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        line.clear();
        return true;
    }
    if (stream.fail()) return false;
    // The line end was taken too, unless the file ended first.
    line.resize(static_cast<std::size_t>(stream.eof() ? taken : taken - 1));
    return true;
}

class Collector {
public:
    explicit Collector(NavigationFile& counts) : counts_(counts) {}

    void take(std::string_view line) {
        const auto sentence = parseNmeaLine(line);
        if (!sentence) return reject(sentence.error());
        const std::string& id = sentence->id;
        if (id == "HDT") return append(readings_.hdt, *sentence, readHeading);
        if (id == "HDG") return append(readings_.hdg, *sentence, readHeading);
        if (id == "RMC") return append(readings_.rmc, *sentence, readPosition);
        if (id == "GGA") return append(readings_.gga, *sentence, readPosition);
        if (id == "VTG") return append(readings_.vtg, *sentence, readVelocity);
        if (id == "VBW") return append(readings_.vbw, *sentence, readVelocity);
        ++counts_.unused[id];
    }
    void reject(std::string_view cause) { ++counts_.rejected[std::string(cause)]; }
    const Readings& readings() const { return readings_; }

private:
    template <class Value>
    void append(Series<Value>& series, const NmeaSentence& sentence, Result<Value> (*read)(const NmeaSentence&)) {
        if (!sentence.time) return reject(nmea_cause::no_time);
        const auto value = read(sentence);
        if (!value) return reject(value.error());
        if (!series.empty() && *sentence.time <= series.back().time) return reject(nmea_cause::out_of_order);
        series.push_back({*sentence.time, *value});
    }

    NavigationFile& counts_;
    Readings readings_;
};

template <class Value>
double longestGap(const Series<Value>& series) {
    double longest_s = 0.0;
    for (std::size_t i = 1; i < series.size(); ++i)
        longest_s = std::max(longest_s, secondsBetween(series[i - 1].time, series[i].time));
    return longest_s;
}

Bearing between(Bearing a, Bearing b, double u) { return a + u * (b - a); }
LocalPosition between(const LocalPosition& a, const LocalPosition& b, double u) {
    return {a.north_m + u * (b.north_m - a.north_m), a.east_m + u * (b.east_m - a.east_m)};
}

template <class Value>
bool covers(const Series<Value>& series, Timestamp time) {
    return !series.empty() && series.front().time <= time && time <= series.back().time;
}

/// Linear between the neighbours of `time`, which the series must cover.
template <class Value>
Value valueAt(const Series<Value>& series, Timestamp time) {
    assert(covers(series, time));
    const auto after = std::lower_bound(series.begin(), series.end(), time,
                                        [](const Timed<Value>& sample, Timestamp t) { return sample.time < t; });
    if (after->time == time) return after->value;
    const auto& before = *std::prev(after);
    const double u = secondsBetween(before.time, time) / secondsBetween(before.time, after->time);
    return between(before.value, after->value, u);
}

Series<LocalPosition> inLocalPlane(const Series<GeographicPosition>& fixes) {
    const LocalPlane plane(fixes.front().value);
    Series<LocalPosition> positions;
    for (const auto& fix : fixes) positions.push_back({fix.time, plane.toLocal(fix.value)});
    return positions;
}

/// Distance run since the first speed. A speed along the vehicle needs its heading; without one it is left out.
Series<LocalPosition> reckoned(const Series<GroundVelocity>& speeds, const Series<Bearing>& headings) {
    Series<LocalPosition> track;
    LocalPosition velocity_before{};  // in m/s
    for (const auto& [time, speed] : speeds) {
        if (speed.along_vehicle && !covers(headings, time)) continue;
        const double turn = speed.along_vehicle ? valueAt(headings, time).inRadians() : 0.0;
        const double c = std::cos(turn);
        const double s = std::sin(turn);
        const LocalPosition velocity{c * speed.north_or_ahead_mps - s * speed.east_or_starboard_mps,
                                     s * speed.north_or_ahead_mps + c * speed.east_or_starboard_mps};
        LocalPosition position{};
        if (!track.empty()) {
            const double half_s = secondsBetween(track.back().time, time) / 2.0;
            position = {track.back().value.north_m + half_s * (velocity_before.north_m + velocity.north_m),
                        track.back().value.east_m + half_s * (velocity_before.east_m + velocity.east_m)};
        }
        track.push_back({time, position});
        velocity_before = velocity;
    }
    return track;
}

/// Writes down what became of a series: `taken` of its samples are in the poses, the rest were not needed.
void countKind(NavigationFile& file, const std::string& id, std::size_t all, std::size_t taken) {
    if (taken > 0) file.used[id] += taken;
    if (all > taken) file.unused[id] += all - taken;
}

Series<Bearing> chooseHeadings(const Readings& readings, NavigationFile& file) {
    const bool is_true = !readings.hdt.empty();
    const Series<HeadingReading>& chosen = is_true ? readings.hdt : readings.hdg;
    countKind(file, "HDT", readings.hdt.size(), is_true ? readings.hdt.size() : 0);
    countKind(file, "HDG", readings.hdg.size(), is_true ? 0 : readings.hdg.size());
    Series<Bearing> headings;
    bool magnetic = false;
    for (const auto& [time, reading] : chosen) {
        headings.push_back({time, reading.heading});
        magnetic = magnetic || reading.magnetic;
    }
    file.longest_heading_gap_s = longestGap(headings);
    file.mode = is_true ? "HDT" : magnetic ? "HDG, magnetic" : "HDG";
    return headings;
}

/// The positions to use, empty with headings only; completes `mode`, which holds the headings' kind.
Series<LocalPosition> choosePositions(const Readings& readings, const Series<Bearing>& headings, NavigationFile& file) {
    const bool rmc = readings.rmc.size() >= readings.gga.size();
    const Series<GeographicPosition>& fixes = rmc ? readings.rmc : readings.gga;
    const bool fixed = fixes.size() >= 2;
    const bool vtg = readings.vtg.size() >= readings.vbw.size();
    Series<LocalPosition> positions =
        fixed ? inLocalPlane(fixes) : reckoned(vtg ? readings.vtg : readings.vbw, headings);
    const bool by_speed = !fixed && positions.size() >= 2;
    if (!fixed && !by_speed) positions.clear();

    countKind(file, "RMC", readings.rmc.size(), fixed && rmc ? positions.size() : 0);
    countKind(file, "GGA", readings.gga.size(), fixed && !rmc ? positions.size() : 0);
    countKind(file, "VTG", readings.vtg.size(), by_speed && vtg ? positions.size() : 0);
    countKind(file, "VBW", readings.vbw.size(), by_speed && !vtg ? positions.size() : 0);
    file.longest_position_gap_s = longestGap(positions);
    if (fixed)
        file.mode = "heading (" + file.mode + ") and position (" + (rmc ? "RMC)" : "GGA)");
    else if (by_speed)
        file.mode = "heading (" + file.mode + "), position reckoned from speed (" + (vtg ? "VTG)" : "VBW)");
    else
        file.mode = "heading only (" + file.mode + ")";
    return positions;
}

void addPoses(const Series<Bearing>& headings, const Series<LocalPosition>& positions, PoseHistory& poses) {
    std::vector<Timestamp> times;
    for (const auto& heading : headings)
        if (positions.empty() || covers(positions, heading.time)) times.push_back(heading.time);
    for (const auto& position : positions)
        if (covers(headings, position.time)) times.push_back(position.time);
    std::ranges::sort(times);
    const auto doubled = std::ranges::unique(times);
    times.erase(doubled.begin(), doubled.end());
    for (const Timestamp time : times) {
        const LocalPosition at = positions.empty() ? LocalPosition{} : valueAt(positions, time);
        poses.add({time, Pose{at.north_m, at.east_m, valueAt(headings, time)}});
    }
}

/// "; rejected: bad_checksum 12, no_time 3", or nothing.
std::string rejectedText(const NavigationFile& file) {
    std::string text;
    for (const auto& [cause, count] : file.rejected)
        text += (text.empty() ? "; rejected: " : ", ") + cause + " " + std::to_string(count);
    return text;
}

}  // namespace

Result<NavigationFile> readNavigationFile(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{"the navigation file " + path + " cannot be opened"};
    NavigationFile file;
    Collector collector(file);
    std::string line;
    bool too_long = false;
    while (nextLine(stream, line, too_long)) {
        if (too_long)
            collector.reject(nmea_cause::malformed);
        else if (line.find_first_not_of(" \r") != std::string::npos)
            collector.take(line);
    }
    const Series<Bearing> headings = chooseHeadings(collector.readings(), file);
    if (headings.empty())
        return Error{"the navigation file " + path + " holds no usable heading (HDT or HDG)" + rejectedText(file)};
    addPoses(headings, choosePositions(collector.readings(), headings, file), file.poses);
    if (file.poses.empty())
        return Error{"the headings and the positions in the navigation file " + path + " have no time in common"};
    return file;
}

}  // namespace echotrail
