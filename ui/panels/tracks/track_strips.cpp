#include "ui/panels/tracks/track_strips.hpp"

#include "ui/style/formatter.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

Strip rangeStrip(const std::vector<TrackLook>& history, const QString& name) {
    Strip strip{name, Formatter::unknown()};
    for (const TrackLook& look : history) strip.points.push_back({look.time, look.range_m, look.seen});
    if (!history.empty()) strip.value = Formatter::rangeNumber(history.back().range_m);
    return strip;
}

/// Unwrapped, so that a target that crosses the stern draws no cliff.
Strip bearingStrip(const std::vector<TrackLook>& history, const QString& name) {
    Strip strip{name, Formatter::unknown()};
    strip.least_span = 4.0;
    double turned_deg = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (i == 0) turned_deg = history[i].bearing.inDegrees();
        if (i > 0) turned_deg += degreesFromRadians(history[i].bearing - history[i - 1].bearing);
        strip.points.push_back({history[i].time, turned_deg, history[i].seen});
    }
    if (!history.empty()) strip.value = Formatter::bearingNumber(history.back().bearing);
    return strip;
}

}  // namespace

std::vector<Strip> TrackStrips::of(const Track& track, const std::vector<TrackSample>& samples) {
    Strip weight{tr("Weight"), Formatter::unknown()};
    Strip nis{tr("NIS, 95 % 5.99"), Formatter::unknown()};
    weight.from_zero = nis.from_zero = nis.bars = true;
    nis.limit = nis_limit;
    nis.least_span = 1.5 * nis_limit;
    for (const TrackSample& sample : samples) {
        weight.points.push_back({sample.time, sample.likeness, true});
        nis.points.push_back({sample.time, sample.nis, true});
    }
    if (!samples.empty()) {
        weight.value = Formatter::probability(samples.back().likeness);
        nis.value = Formatter::number(samples.back().nis, 2);
    }
    Strip missed{tr("Missed, 20 %"), Formatter::unknown()};
    missed.from_zero = true;
    missed.limit = most_missed;
    missed.least_span = 2.0 * most_missed;
    const std::vector<double> shares = missedShares(track.history);
    for (std::size_t i = 0; i < shares.size(); ++i)
        missed.points.push_back({track.history[i].time, shares[i], !track.history[i].seen});
    if (!shares.empty()) missed.value = Formatter::withUnit(100.0 * shares.back(), 0, "%");
    return {rangeStrip(track.history, tr("Range m")), bearingStrip(track.history, tr("Bearing °R")), weight, nis,
            missed};
}

double TrackStrips::length(const Track& track, const std::vector<TrackSample>& samples, Timestamp now) {
    Timestamp first = now;
    if (!track.history.empty()) first = std::min(first, track.history.front().time);
    if (!samples.empty()) first = std::min(first, samples.front().time);
    return secondsBetween(first, now);
}

}  // namespace echotrail
