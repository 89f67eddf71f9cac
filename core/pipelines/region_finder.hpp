#pragma once

#include "core/data/beam_line.hpp"
#include "core/data/ping.hpp"
#include "core/data/region.hpp"
#include "core/detection/echo_conditioner.hpp"
#include "core/detection/echo_screen.hpp"
#include "core/detection/recent_regions.hpp"
#include "core/detection/region_grower.hpp"
#include "core/features/region_shape.hpp"
#include "core/imaging/filters.hpp"
#include "core/imaging/ray.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace echotrail {

struct RegionFinderParams {
    EchoConditionerParams conditioner;
    EchoScreenParams screen;
    GaussianParams smoothing;
    RegionGrowerParams grower;
    RegionShapeParams shape;
};

template <>
struct Described<RegionFinderParams> {
    using P = RegionFinderParams;
    static constexpr auto stages = std::tuple{&P::conditioner, &P::screen, &P::smoothing, &P::grower, &P::shape};
};

/// From echo lines to regions, as soon as the beam has left them: the screen says where something strong was; just
/// that part of the fan is painted, motion-corrected as in the big picture, and regions are grown in it. A whole
/// sweep is never searched, so the cost and the delay of a ping stay small.
/// Order: rays in time order; breakOff() where the beam's movement breaks off.
/// State: the last echo rows, the screen's open candidates, the peaks found lately.
class RegionFinder {
public:
    explicit RegionFinder(const RegionFinderParams& params);
    void setParams(const RegionFinderParams& params);

    /// Completes what the beam was on; call before add() when it has turned round.
    void breakOff(std::vector<Region>& regions);
    /// Takes in a ping; appends the regions the beam has left. `ray` places it in the local frame.
    void add(const Ping& ping, const Ray& ray, const Pose& head, Timestamp epoch,
             std::span<const RangeOfInterest> interests, std::vector<Region>& regions);
    /// Whether the beam is still on something between these ranges.
    bool isOpenWithin(double near_m, double far_m) const { return screen_.isOpenWithin(near_m, far_m); }
    /// The last ping as it was compared with the threshold; empty before the first one. Its bearings are not known
    /// here.
    BeamLine lastLine() const;
    /// No region that is still to come is of an earlier time. Empty before the first ping.
    std::optional<Timestamp> settledUntil() const;

private:
    struct Row {
        EchoRow echo;
        Ray ray;  ///< its levels are those of `echo`
        Pose head;
        Timestamp time{};
        double pixel_m = 0.0;
    };
    struct FoundPeak {
        Timestamp time{};
        int row, column;  ///< on the world's pixel grid
    };

    Row& rowAt(std::uint64_t number) { return rows_[number % rows_.size()]; }
    const Row& rowAt(std::uint64_t number) const { return rows_[number % rows_.size()]; }
    void growRegions(const Candidate& candidate, std::vector<Region>& regions);
    bool layTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m);
    void paintTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m);
    bool isNew(const RegionPixels& pixels, Timestamp time);
    int beamHits(const Region& region, std::uint64_t first, std::uint64_t last) const;
    const Row& rowNearest(Timestamp time, std::uint64_t first, std::uint64_t last) const;
    void flagMultipath(std::vector<Region>& regions);

    RegionFinderParams params_;
    EchoConditioner conditioner_;
    EchoScreen screen_;
    RegionGrower grower_;
    std::vector<Row> rows_;  ///< ring, by row number as the screen counts
    std::uint64_t next_row_ = 0;
    std::uint64_t sweep_first_row_ = 0;  ///< rows before it belong to another movement of the beam
    std::vector<Candidate> candidates_;
    FanImage tile_;  ///< echo levels
    FanImage background_tile_;
    cv::Mat tile_memory_, time_memory_, background_memory_, background_time_memory_;
    Timestamp epoch_{};
    std::deque<FoundPeak> found_;
    RecentRegions recent_;  ///< for telling multipath
    std::uint32_t next_id_ = 1;
};

}  // namespace echotrail
