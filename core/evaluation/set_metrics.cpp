#include "core/evaluation/set_metrics.hpp"

#include "core/tracking/association.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

using Points = std::span<const Eigen::Vector2d>;
constexpr double debris_reach_m = 2.0;  // a track on debris stands for a target only this near to it

/// Squared distances of the best pairing of the smaller set with the larger one, each at most the cut-off's square.
std::vector<double> pairedSquares(Points a, Points b, double cutoff_m) {
    if (a.size() > b.size()) std::swap(a, b);
    std::vector<std::vector<double>> cost(a.size(), std::vector<double>(b.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            cost[i][j] = std::min((a[i] - b[j]).squaredNorm(), cutoff_m * cutoff_m);
    std::vector<double> squares;
    if (a.empty()) return squares;
    const std::vector<int> column = leastCostAssignment(cost);
    for (std::size_t i = 0; i < a.size(); ++i) squares.push_back(cost[i][static_cast<std::size_t>(column[i])]);
    return squares;
}

double distanceToNearest(const Eigen::Vector2d& place, const std::vector<SweepSnapshot::Object>& objects,
                         bool visible) {
    double nearest = HUGE_VAL;
    for (const SweepSnapshot::Object& object : objects)
        if (object.visible == visible) nearest = std::min(nearest, (object.position_m - place).norm());
    return nearest;
}

}  // namespace

double ospa(Points estimates, Points truths, double cutoff_m) {
    const auto most = static_cast<double>(std::max(estimates.size(), truths.size()));
    if (most == 0) return 0;
    const std::vector<double> squares = pairedSquares(estimates, truths, cutoff_m);
    double sum = cutoff_m * cutoff_m * (most - static_cast<double>(squares.size()));
    for (const double square : squares) sum += square;
    return std::sqrt(sum / most);
}

double Gospa::distance() const { return std::sqrt(localisation_m2 + missed_m2 + false_m2); }

Gospa gospa(Points estimates, Points truths, double cutoff_m) {
    const double limit = cutoff_m * cutoff_m;
    Gospa result;
    std::size_t found = 0;
    // With α = 2 a pair at the cut-off costs as much as one missed and one false: it is told as those.
    for (const double square : pairedSquares(estimates, truths, cutoff_m)) {
        if (square >= limit) continue;
        result.localisation_m2 += square;
        ++found;
    }
    result.missed_m2 = limit / 2 * static_cast<double>(truths.size() - found);
    result.false_m2 = limit / 2 * static_cast<double>(estimates.size() - found);
    return result;
}

double ClearMot::Counts::mota() const {
    return objects == 0 ? 0 : 1 - static_cast<double>(misses + false_positives + switches) / objects;
}

double ClearMot::Counts::motp_m() const { return matches == 0 ? 0 : distance_m / matches; }

void ClearMot::Counts::add(const Counts& other) {
    objects += other.objects;
    misses += other.misses;
    false_positives += other.false_positives;
    switches += other.switches;
    matches += other.matches;
    distance_m += other.distance_m;
}

void ClearMot::match(const Point& target, const Point& track) {
    const auto [last, first] = last_track_.try_emplace(target.id, track.id);
    counts_.switches += !first && last->second != track.id;
    last->second = track.id;
    ++counts_.matches;
    counts_.distance_m += (target.position_m - track.position_m).norm();
}

void ClearMot::addFrame(std::span<const Point> tracks, std::span<const Point> targets) {
    const auto near = [&](const Point& a, const Point& b) { return (a.position_m - b.position_m).norm() < longest_m_; };
    std::vector<Point> open_targets, open_tracks(tracks.begin(), tracks.end());
    std::size_t found = 0;
    for (const Point& target : targets) {
        const auto last = last_track_.find(target.id);
        const auto kept = std::find_if(open_tracks.begin(), open_tracks.end(), [&](const Point& track) {
            return last != last_track_.end() && track.id == last->second && near(track, target);
        });
        if (kept == open_tracks.end()) {
            open_targets.push_back(target);
            continue;
        }
        match(target, *kept);
        open_tracks.erase(kept);
        ++found;
    }
    // As many columns again stand for "not found", each dearer than any pairing that is near enough.
    const double dear = static_cast<double>(targets.size() + 1) * longest_m_ * longest_m_;
    std::vector<std::vector<double>> cost;
    for (const Point& target : open_targets) {
        auto& row = cost.emplace_back(open_tracks.size() + open_targets.size(), dear);
        for (std::size_t j = 0; j < open_tracks.size(); ++j)
            if (near(target, open_tracks[j])) row[j] = (target.position_m - open_tracks[j].position_m).squaredNorm();
    }
    const std::vector<int> column = cost.empty() ? std::vector<int>() : leastCostAssignment(cost);
    for (std::size_t i = 0; i < column.size(); ++i) {
        const auto j = static_cast<std::size_t>(column[i]);
        if (j >= open_tracks.size() || !near(open_targets[i], open_tracks[j])) continue;
        match(open_targets[i], open_tracks[j]);
        ++found;
    }
    counts_.objects += static_cast<int>(targets.size());
    counts_.misses += static_cast<int>(targets.size() - found);
    counts_.false_positives += static_cast<int>(tracks.size() - found);
}

ComparedSets comparedSets(const SweepSnapshot& snapshot, double cutoff_m) {
    ComparedSets sets;
    for (const SweepSnapshot::Object& object : snapshot.objects)
        if (object.visible) sets.targets.push_back({object.target, object.position_m});
    for (const SweepSnapshot::Estimate& estimate : snapshot.estimates) {
        const double seen = distanceToNearest(estimate.position_m, snapshot.objects, true);
        const double unseen = distanceToNearest(estimate.position_m, snapshot.objects, false);
        const bool of_debris = estimate.on_debris && seen > debris_reach_m;
        const bool of_unseen = unseen < cutoff_m && unseen < seen;
        if (!of_debris && !of_unseen) sets.tracks.push_back({estimate.track, estimate.position_m});
    }
    return sets;
}

std::vector<Eigen::Vector2d> positionsOf(std::span<const ClearMot::Point> points) {
    std::vector<Eigen::Vector2d> positions;
    for (const ClearMot::Point& point : points) positions.push_back(point.position_m);
    return positions;
}

}  // namespace echotrail
