#pragma once

#include "core/runtime/scene.hpp"
#include "ui/models/track_samples.hpp"
#include "ui/panels/tracks/strip_chart.hpp"

#include <QCoreApplication>

namespace echotrail {

/// The course of a track as lanes of a strip chart.
class TrackStrips {
    Q_DECLARE_TR_FUNCTIONS(TrackStrips)

public:
    static constexpr double nis_limit = 5.99;  ///< 95 % of a consistent track's values lie below: χ² of two dimensions
    static constexpr double most_missed = 0.20;  ///< share of covered looks without an echo that a track should keep

    /// Range, bearing, weight, NIS with its 95 % bound, share of covered looks without an echo.
    static std::vector<Strip> of(const Track& track, const std::vector<TrackSample>& samples);
    /// Seconds from the oldest of them to `now`.
    static double length(const Track& track, const std::vector<TrackSample>& samples, Timestamp now);
};

}  // namespace echotrail
