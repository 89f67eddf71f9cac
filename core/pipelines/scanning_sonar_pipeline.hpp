#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/data/head_settings.hpp"
#include "core/data/ping.hpp"
#include "core/data/pose.hpp"
#include "core/data/source.hpp"
#include "core/data/update.hpp"
#include "core/detection/echo_conditioner.hpp"
#include "core/detection/echo_screen.hpp"
#include "core/detection/region_grower.hpp"
#include "core/imaging/fan_projector.hpp"
#include "core/imaging/local_enhancement.hpp"
#include "core/pipelines/region_finder.hpp"
#include "core/pipelines/sweep_follower.hpp"
#include "core/tracking/tracker.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace echotrail {

struct NavigationParams {
    double longest_navigation_gap_s = 1.0;
};

template <>
struct Described<NavigationParams> {
    static constexpr std::string_view group = "Navigation";
    static constexpr auto fields = std::tuple{
        Field{&NavigationParams::longest_navigation_gap_s, "longest_navigation_gap_s", "s", 0.05, 60,
              "A ping further than this from any measured pose has none: the picture breaks off and tracks coast"}};
};

/// From pings to tracks. One object runs on board, in the console and on a recording; nothing in it knows which.
/// Order:   pings in time order; finish() once, after the last.
/// Threads: none; one owner calls it.
class ScanningSonarPipeline {
public:
    struct Params {
        HeadSettings head;
        NavigationParams navigation;
        FanProjector::Params fan;
        LocalEnhancementParams enhancement;  ///< for the eye, and for regions where detect_on says so
        RegionFinderParams regions;
        Tracker::Params tracker;
        FollowParams follow;
    };

    ScanningSonarPipeline(const Params& params, std::uint64_t seed);

    /// Takes in one ping. The update is valid until the next call.
    const Update& process(const Ping& ping, const PoseHistory& navigation);
    /// Closes the last sweep: the regions and looks that were still open.
    const Update& finish();

    /// Takes effect between two pings. Tracks live on.
    void setParams(const Params& params);
    const Params& params() const { return params_; }

    /// The operator's pick: a proven track at this place, the target that was lost near it, or else the first region or
    /// track within max(3 m, 10 % of the range), waiting as long as needed; until that is proven, a stronger one nearby
    /// goes before. The place is relative to the head at the latest ping (before any: the first).
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();
    /// As in the tracker; range and bearing are where the operator saw the track, with the radius of a pick.
    void drop(int track, double range_m, Bearing from_bow);
    void restore(int track) { tracker_.restore(track); }
    bool isDropped(int track) const { return tracker_.isDropped(track); }
    /// What the operator did, except parameters: those are setParams()'s.
    void command(const RunControl& control);

    /// The followed objects as they stand now, particles included: a copy, made when asked for.
    std::vector<Track> tracks() const { return tracker_.tracks(); }
    /// The picture so far, in the local frame; empty before the first wedge, or when painting is off.
    const FanImage& fan() const { return fan_.image(); }
    /// What the head is to scan from here on: about the target, where it follows it (`follow_target`); nothing where
    /// the sector of Params is to be scanned. A recording has been scanned as it was: there this changes nothing.
    const std::optional<ScanSector>& sector() const { return follower_.chosen(); }
    /// The target as it is expected at `time`; nothing where there is none.
    std::optional<TargetOutlook> targetAt(Timestamp time) const { return tracker_.targetAt(time); }
    /// The last ping's echo line with its detection threshold; empty before the first one.
    BeamLine lastLine() const;
    /// No look that is still to come is of an earlier time; so what is older can be written in order.
    Timestamp settledUntil() const;
    void setFanPainting(bool on) { paint_fan_ = on; }
    /// Where the local frame's origin lies in the frame of navigation: where the vehicle was at the first ping. None
    /// before a ping with a measured pose.
    const std::optional<Pose>& origin() const { return origin_; }
    std::uint64_t confirmedTracks() const { return tracker_.confirmedEver(); }  ///< at any time so far
    std::uint64_t sweeps() const { return sweeps_; }
    std::uint64_t unsynchronisedPings() const { return unsynchronised_; }  ///< dropped: the bearing was not known

private:
    Eigen::Vector2d placeOf(double range_m, Bearing from_bow) const;
    struct Pick {
        double range_m;
        Bearing from_bow;
    };
    BeamMoment beamOf(const Ping& ping, const Ray& ray, const SweepFollower::Step& step, bool navigation_known) const;
    Pose fromStart(const Pose& pose);
    void holdPose(const SweepFollower::Step& step);
    void applyPick();

    Params params_;
    FanProjector fan_;
    RegionFinder regions_;
    Tracker tracker_;
    SectorFollower follower_;
    SweepFollower sweep_;
    Update update_;
    Pose vehicle_;     ///< at the last ping
    BeamMoment beam_;  ///< of the last ping
    std::vector<RangeOfInterest> interests_;
    std::optional<Pick> pick_;
    std::optional<Timestamp> first_ping_;
    std::optional<Pose> held_;    ///< where the sweep began, while motion is not corrected
    std::optional<Pose> origin_;  ///< of the local frame, in the frame of navigation
    bool paint_fan_ = true;
    std::uint64_t sweeps_ = 0;
    std::uint64_t unsynchronised_ = 0;
};

template <>
struct Described<ScanningSonarPipeline::Params> {
    using P = ScanningSonarPipeline::Params;
    static constexpr auto stages =
        std::tuple{&P::head, &P::navigation, &P::fan, &P::enhancement, &P::regions, &P::tracker, &P::follow};
};

}  // namespace echotrail
