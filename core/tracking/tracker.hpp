#pragma once

#include "core/base/parameters.hpp"
#include "core/detection/echo_screen.hpp"
#include "core/detection/recent_regions.hpp"
#include "core/features/target_reference.hpp"
#include "core/filters/gaussian_particle_filter.hpp"
#include "core/tracking/association.hpp"
#include "core/tracking/beam_pass.hpp"
#include "core/tracking/method.hpp"
#include "core/tracking/sector_follower.hpp"
#include "core/tracking/track_life.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace echotrail {

struct TrackerParams {
    double process_noise = 0.05;
    double unknown_turn_deg = 1.0;
    double range_sigma_m = 0.02;
    double centroid_share = 0.018;
    double heading_sigma_deg = 0.14;
    double initial_position_sigma_percent = 1.6;
    double initial_speed_sigma_mps = 0.5;
    double max_speed_mps = 2.0;
    double gate = 13.8;
    double detection_probability = 0.9;
    double clutter_per_sweep = 3.0;
    int min_beam_hits = 2;
    double ghost_density = 0.5;
    double side_lobe_db = 30.0;
    double merge_tracks_m = 1.0;
    int max_tracks = 16;
};

template <>
struct Described<TrackerParams> {
    using P = TrackerParams;
    static constexpr std::string_view group = "Tracking";
    static constexpr auto fields = std::tuple{
        Field{&P::process_noise, "process_noise", "m²/s³", 1e-4, 10,
              "How readily objects change their velocity: power density of the acceleration"},
        Field{&P::unknown_turn_deg, "unknown_turn_deg", "deg/√s", 0, 20,
              "Without a heading sensor: how far the vehicle may turn unnoticed"},
        Field{&P::range_sigma_m, "range_sigma_m", "m", 0.01, 5,
              "Deviation of every place, at the least: sound speed, timing, range bins"},
        Field{&P::centroid_share, "centroid_share", "", 0.005, 1,
              "Deviation of a region's centroid, as a share of the region's length and width"},
        Field{&P::heading_sigma_deg, "heading_sigma_deg", "deg", 0, 20, "Deviation of the heading"},
        Field{&P::initial_position_sigma_percent, "initial_position_sigma_percent", "% of range scale", 0.1, 20,
              "Deviation of a new track's place from its first region"},
        Field{&P::initial_speed_sigma_mps, "initial_speed_sigma_mps", "m/s", 0.01, 10,
              "Deviation of a new track's velocity from rest"},
        Field{&P::max_speed_mps, "max_speed_mps", "m/s", 0.1, 30, "Nothing that is followed moves faster"},
        Field{&P::gate, "gate", "", 2, 40,
              "Squared normalised distance within which a region may be the track's echo; 13.8 holds 99.9 %"},
        Field{&P::detection_probability, "detection_probability", "", 0.1, 0.999,
              "Probability that the object shows when the beam passes"},
        Field{&P::clutter_per_sweep, "clutter_per_sweep", "regions", 0.1, 500,
              "Regions in a sweep that are nobody's echo, before it is learned"},
        Field{&P::min_beam_hits, "min_beam_hits", "pings", 1, 10, "Pings that must meet a region to start a track"},
        Field{
            &P::ghost_density, "ghost_density", "1/m²", 0, 10,
            "Regions per area just behind a stronger one that are its copies by way of bottom or surface; 0: none are"},
        Field{&P::side_lobe_db, "side_lobe_db", "dB", 10, 80,
              "An echo at the range of a followed object, at another bearing and this much weaker, is heard by a side "
              "lobe of the beam; 80: none is"},
        Field{&P::merge_tracks_m, "merge_tracks_m", "m", 0, 10, "Tracks closer than this for three sweeps are one"},
        Field{&P::max_tracks, "max_tracks", "", 1, 64, "Tracks followed at the same time"}};
};

/// A region that no track has claimed or turned down yet.
struct PendingRegion {
    Region region;
    bool claimed = false;
};

/// A track with what only the tracker needs to know of it.
struct FollowedTrack {
    Track track;
    TargetReference reference;
    RegionFeatures first_features;  ///< of the region it began with
    Eigen::Matrix4d first_covariance = Eigen::Matrix4d::Identity();
    BeamPass pass;
    double expected_range_m = 0.0;  ///< at the last ping
    std::uint64_t updates = 0;      ///< names the random stream of the next one
    int good_looks = 0;             ///< running, of a lost track: two bring it back
    int quiet_sweeps = 0;           ///< since the last echo
    double unwatched_s = 0.0;       ///< of the time since the last echo: the head looked only elsewhere
    int shadowed_sweeps = 0;        ///< running, in which an older track was as good as here
    bool dropped = false;           ///< followed on, but nobody is told of it
    bool navigation_gap = false;    ///< since the last look
    bool pings_missing = false;
};

/// Follows several objects at once, one of them the operator's target.
/// A track is updated once for each pass of the beam over its place, when the beam has left it: with the regions
/// found there, jointly with the tracks that share them, or with nothing where there was no echo.
/// Order: update() once per ping, in time order; finish() after the last.
/// State: tracks, unclaimed regions, learned clutter density.
class Tracker {
public:
    struct Params {
        MethodParams method;
        TrackerParams tracking;
        LifeParams life;
        LikenessParams likeness;
        GaussianParticleFilter::Params filter;
    };
    /// Whether the beam is still on an echo between two ranges: a pass is then not over yet.
    using BeamStillOn = std::function<bool(double near_m, double far_m)>;

    Tracker(const Params& params, std::uint64_t seed);
    void setParams(const Params& params);

    /// `regions` are those the beam left before this ping. Appends the looks that were completed.
    void update(const BeamMoment& beam, const std::vector<Region>& regions, const BeamStillOn& still_on,
                std::vector<TrackLook>& looks);
    /// Completes the passes that are still open; `regions` are the last ones.
    void finish(const std::vector<Region>& regions, std::vector<TrackLook>& looks);

    /// Where followed objects are expected at this beam's bearing: there, fainter echoes are worth a look.
    void interestsAt(const BeamMoment& beam, std::vector<RangeOfInterest>& interests) const;

    /// The operator points at a place in the local frame: at a track that is proven, at the target that was lost, or at
    /// the first region or track within `radius_m`, waiting as long as needed. Until that is proven, too, a stronger
    /// one nearby takes its turn.
    void designate(const Eigen::Vector2d& position_m, double radius_m);
    void clearDesignation();
    /// The operator does not want to see this track any more. It keeps its echoes, so that no other begins on them, but
    /// neither looks nor tracks() tell of it. Only where it is within `radius_m` of the place: in a run with other
    /// parameters the number may be another object's. False where there is none.
    bool drop(int track, const Eigen::Vector2d& position_m, double radius_m);
    /// It is told of again, as also when it is designated; nothing where it was given up meanwhile.
    void restore(int track);
    bool isDropped(int track) const;

    /// The operator's target as it is expected at `time`, as surely as it is known now; nothing where there is none.
    std::optional<TargetOutlook> targetAt(Timestamp time) const;

    /// The tracks that are followed, lost ones that may still come back included, dropped ones not.
    std::vector<Track> tracks() const;
    /// No look that is still to come is of an earlier time, provided that no region is: see `regions_until`.
    Timestamp settledUntil(Timestamp regions_until) const;
    std::uint64_t confirmedEver() const { return confirmed_ever_; }
    /// Regions per m² and sweep that are nobody's echo.
    double clutterDensity() const;

private:
    struct Pairing {
        bool gated = false;
        double likeness = 0.0;
        double strength_ratio = 1.0;
        double density = 0.0;  ///< N(innovation; 0, S)
        double nis = 0.0;
        double innovation_m = 0.0;
        double probability = 0.0;  ///< that the region is the track's echo
        Cue cue;
    };
    struct Designation {
        Eigen::Vector2d position_m;
        double radius_m;
        bool fresh = true;  ///< what is proven by now goes before
    };

    GaussianState predict(const FollowedTrack& followed, Timestamp time) const;
    Eigen::Matrix2d measurementCovariance(const Region& region, const RegionFeatures& expected) const;
    EchoGeometry geometryAt(double range_m) const;
    bool isGhost(const Region& region) const;
    bool isSideLobe(const Region& region) const;
    bool isArc(const Region& region) const;
    Pairing pair(const FollowedTrack& followed, const Region& region) const;
    Pairing pairAsPublished(const FollowedTrack& followed, const Region& region) const;
    /// What the region's being the track's echo is worth, against its being clutter or the ghost of another:
    /// P_D/λ · likeness · strength, m².
    double worth(const Pairing& pairing, bool ghost) const;
    double halfWidth(const ExpectedPlace& place) const;

    void settle(const BeamStillOn& still_on, std::vector<TrackLook>& looks);
    bool collectCluster(std::size_t first, const BeamStillOn& still_on, std::vector<std::size_t>& members,
                        std::vector<std::size_t>& regions) const;
    bool isReady(const FollowedTrack& followed, const BeamStillOn& still_on) const;
    void processCluster(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                        std::vector<TrackLook>& looks);
    void settleTies(const std::vector<std::size_t>& members, Association& joint) const;
    std::vector<std::size_t> bySeniority(const std::vector<std::size_t>& members) const;
    bool isProvenWithoutEcho(std::size_t member, double none) const;
    void keepOwn(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                 const std::vector<std::vector<Pairing>>& pairings, Association& joint) const;
    void shareMerged(const std::vector<std::size_t>& members, const std::vector<std::size_t>& regions,
                     const Association& alone, const std::vector<std::vector<Pairing>>& pairings,
                     Association& joint) const;
    void completePass(FollowedTrack& followed, const std::vector<std::size_t>& regions,
                      const std::vector<Pairing>& pairings, const std::vector<double>& joint, double joint_none,
                      const std::vector<double>& alone, double alone_none, std::vector<TrackLook>& looks);
    void processAsPublished(FollowedTrack& followed, const std::vector<std::size_t>& regions,
                            std::vector<TrackLook>& looks);
    GaussianParticleFilter::Posterior updateByPlace(const GaussianState& prior, double miss_weight,
                                                    const std::vector<Cue>& cues) const;
    /// What came of a pass, into the track and its looks. `region` is the echo that was taken, if any.
    void concludePass(FollowedTrack& followed, const GaussianParticleFilter::Posterior& posterior, Timestamp time,
                      const Region* region, const Pairing& pairing, bool had_cues, NoEcho cause,
                      std::vector<TrackLook>& looks);
    /// Why a pass found no echo of a track among `regions`, which it was paired with.
    NoEcho whyNoEcho(const FollowedTrack& followed, Timestamp time, const std::vector<std::size_t>& regions,
                     const std::vector<Pairing>& pairings) const;
    NoEcho whyNotScanned(const FollowedTrack& followed) const;
    RegionFeatures expectedFeatures(const FollowedTrack& followed, double range_m) const;
    void takeEcho(FollowedTrack& followed, const Region& region, const Pairing& pairing);
    void searchAgain(FollowedTrack& followed, LookResult result, Timestamp time);
    TrackLook lookOf(const FollowedTrack& followed, Timestamp time, NoEcho cause, const Pose& head) const;
    static void remember(const TrackLook& look, Track& track);

    void decideBirths(std::vector<TrackLook>& looks);
    bool mayBeBorn(const Region& region) const;
    void bear(const Region& region, std::vector<TrackLook>& looks);
    void applyDesignation();
    bool findLostTarget(const Eigen::Vector2d& position_m, double radius_m);
    Eigen::Vector2d placeNow(const FollowedTrack& followed) const;
    void hushDropped(std::vector<TrackLook>& looks) const;
    void giveUpUnseen(std::vector<TrackLook>& looks);
    void learnClutter(const Region& region);
    void waitUnwatched(FollowedTrack& followed, const ExpectedPlace& place, double passed_s) const;
    bool isPartOfSweep() const;
    void endSweep();
    void mergeTracks();

    Params params_;
    std::uint64_t seed_;
    GaussianParticleFilter filter_;
    BeamMoment beam_;
    std::vector<FollowedTrack> followed_;
    std::vector<PendingRegion> pending_;
    RecentRegions recent_;  ///< claimed or not
    std::optional<Designation> designation_;
    int next_id_ = 1;
    std::uint64_t confirmed_ever_ = 0;
    double clutter_per_sweep_;
    int sweeps_learned_ = 0;
    double swept_area_m2_ = 0.0;      ///< of the last whole sweep
    double clutter_excess_db_ = 4.0;  ///< running mean of how far such regions exceed the faintest
    double clutter_score_ = 0.25;     ///< running mean likeness of regions that were nobody's echo
    double scanned_area_m2_ = 0.0;    ///< in this sweep
    double scanned_turn_rad_ = 0.0;   ///< in this sweep
    int unclaimed_ = 0;               ///< regions in this sweep that were nobody's echo
};

template <>
struct Described<Tracker::Params> {
    using P = Tracker::Params;
    static constexpr auto stages = std::tuple{&P::method, &P::tracking, &P::life, &P::likeness, &P::filter};
};

}  // namespace echotrail
