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
#include "core/imaging/local_enhancement.hpp"
#include "core/imaging/ray.hpp"
#include "core/imaging/wedge_painter.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace echotrail {

/// Which picture regions are grown in.
enum class DetectOn {
    Echoes,        ///< the part of the fan where a strong echo was, when the beam has left it
    Sweep,         ///< the whole picture of a sweep, when that is over: as published, but for the enhancement
    EnhancedSweep  ///< that picture with its local contrast stretched: as published
};

struct DetectionPictureParams {
    DetectOn detect_on = DetectOn::Echoes;
};

template <>
struct Described<DetectionPictureParams> {
    using P = DetectionPictureParams;
    static constexpr std::string_view group = "Detection's picture";
    static constexpr auto fields = std::tuple{ChoiceField<P, DetectOn, 3>{
        &P::detect_on,
        "detect_on",
        {"echoes", "sweep", "enhanced_sweep"},
        "Where regions are grown: about strong echoes when the beam has left them, or in the whole picture of a sweep "
        "when it is over, plain or with its local contrast stretched",
        Effect::NextSweep}};
};

struct RegionFinderParams {
    EchoConditionerParams conditioner;
    EchoScreenParams screen;
    GaussianParams smoothing;
    RegionGrowerParams grower;
    RegionShapeParams shape;
    DetectionPictureParams picture;
};

template <>
struct Described<RegionFinderParams> {
    using P = RegionFinderParams;
    static constexpr auto stages =
        std::tuple{&P::conditioner, &P::screen, &P::smoothing, &P::grower, &P::shape, &P::picture};
};

/// From echo lines to regions, as soon as the beam has left them: the screen says where something strong was; just
/// that part of the fan is painted, motion-corrected as in the big picture, and regions are grown in it. A whole
/// sweep is never searched, so the cost and the delay of a ping stay small. Parameter detect_on asks for the published
/// way instead: the whole picture of a sweep, when that is over.
/// Order: rays in time order; breakOff() where the beam's movement breaks off, and where the sweep ends if
/// waitsForSweep() says so.
/// State: the last echo rows, the screen's open candidates, the peaks found lately.
class RegionFinder {
public:
    /// `enhancement` is used where regions are grown in the enhanced picture.
    explicit RegionFinder(const RegionFinderParams& params, const LocalEnhancementParams& enhancement = {});
    void setParams(const RegionFinderParams& params, const LocalEnhancementParams& enhancement = {});

    /// Completes what the beam was on; call before add() when it has turned round.
    void breakOff(std::vector<Region>& regions);
    /// Takes in a ping; appends the regions the beam has left. `ray` places it in the local frame.
    void add(const Ping& ping, const Ray& ray, const Pose& head, Timestamp epoch,
             std::span<const RangeOfInterest> interests, std::vector<Region>& regions);
    /// Whether regions come when the sweep is over.
    bool waitsForSweep() const { return params_.picture.detect_on != DetectOn::Echoes; }
    /// Whether regions between these ranges may still come of what the beam was on up to now.
    bool isOpenWithin(double near_m, double far_m) const;
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
    void growInSweep(std::vector<Region>& regions);
    void keepRegion(const RegionPixels& pixels, std::uint64_t first, std::uint64_t last, RangeInterval inside,
                    std::vector<Region>& regions);
    bool layTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m);
    void paintTile(std::uint64_t first, std::uint64_t last, double near_m, double far_m);
    void paintBackground(std::uint64_t first, std::uint64_t last, double near_m, double far_m);
    std::uint64_t sweepFirstRow() const;
    bool isNew(const RegionPixels& pixels, Timestamp time);
    int beamHits(const Region& region, std::uint64_t first, std::uint64_t last) const;
    const Row& rowNearest(Timestamp time, std::uint64_t first, std::uint64_t last) const;
    void flagMultipath(std::vector<Region>& regions);

    RegionFinderParams params_;
    LocalEnhancementParams enhancement_;
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
