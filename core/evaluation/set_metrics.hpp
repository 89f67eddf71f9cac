#pragma once

#include "core/evaluation/trial.hpp"

#include <Eigen/Core>

#include <map>
#include <span>
#include <vector>

/// How well the whole set of confirmed tracks stands for the set of true targets. Orders and the cut-off are those of
/// the method card: p = 2, α = 2, c = 7.5 m.
namespace echotrail {

inline constexpr double set_cutoff_m = 7.5;

/// Optimal subpattern assignment distance of order 2 (Schuhmacher, Vo & Vo 2008), in metres: 0 for equal sets (two
/// empty ones, too), the cut-off where one is empty.
double ospa(std::span<const Eigen::Vector2d> estimates, std::span<const Eigen::Vector2d> truths,
            double cutoff_m = set_cutoff_m);

/// Generalised OSPA with p = 2 and α = 2 (Rahmathullah, García-Fernández & Svensson 2017). Its square falls into
/// three parts: errors of those found, and c²/2 for every target missed and every false track.
struct Gospa {
    double localisation_m2 = 0.0;
    double missed_m2 = 0.0;
    double false_m2 = 0.0;
    double distance() const;  ///< in metres
};
Gospa gospa(std::span<const Eigen::Vector2d> estimates, std::span<const Eigen::Vector2d> truths,
            double cutoff_m = set_cutoff_m);

/// CLEAR MOT (Bernardin & Stiefelhagen 2008). A target keeps the track it had while that is near enough; the others are
/// paired so that most find one and their distances are least.
class ClearMot {
public:
    struct Point {
        int id = 0;
        Eigen::Vector2d position_m{0, 0};
    };
    struct Counts {
        int objects = 0;  ///< targets, summed over frames
        int misses = 0;
        int false_positives = 0;
        int switches = 0;  ///< a target is found by another track than the last one that found it
        int matches = 0;
        double distance_m = 0.0;  ///< summed over matches

        double mota() const;    ///< 1 − (misses + false positives + switches) / objects; 0 without objects
        double motp_m() const;  ///< mean distance of matches
        void add(const Counts& other);
    };

    explicit ClearMot(double longest_m = set_cutoff_m) : longest_m_(longest_m) {}
    void addFrame(std::span<const Point> tracks, std::span<const Point> targets);
    const Counts& counts() const { return counts_; }

private:
    void match(const Point& target, const Point& track);

    double longest_m_;
    Counts counts_;
    std::map<int, int> last_track_;  ///< target → the track that found it last
};

/// A snapshot made ready for these measures: targets out of sight need no track, and a track of one is not false; nor
/// is one of debris, unless it is also at a target.
struct ComparedSets {
    std::vector<ClearMot::Point> tracks;
    std::vector<ClearMot::Point> targets;
};
ComparedSets comparedSets(const SweepSnapshot& snapshot, double cutoff_m = set_cutoff_m);

std::vector<Eigen::Vector2d> positionsOf(std::span<const ClearMot::Point> points);

}  // namespace echotrail
