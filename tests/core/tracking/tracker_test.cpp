#include "core/tracking/tracker.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace echotrail {
namespace {

constexpr double step_deg = 1.8, ping_s = 0.1, half_sector_deg = 45.0;

struct Object {
    Eigen::Vector2d start{20, 0}, velocity{0, 0};
    double area_m2 = 0.6;
    double visible_from_s = 0, hidden_from_s = 1e9, shown_again_s = 1e9;
    double peak_db = 60;
    double strength_db = 25;
    Eigen::Vector2d at(double t) const { return start + t * velocity; }
    bool shows(double t) const { return t >= visible_from_s && (t < hidden_from_s || t >= shown_again_s); }
};

/// A beam that scans ±45° to and fro over moving objects; each gives a region two pings after the beam was on it.
class Scene {
public:
    explicit Scene(std::vector<Object> objects, Tracker::Params params = {}, std::uint64_t seed = 1)
        : tracker(params, seed), objects_(std::move(objects)), noise_(seed, 77, 0) {}

    void run(double until_s) {
        for (; ping_ * ping_s < until_s; ++ping_) {
            const double t = ping_ * ping_s;
            const int per_sweep = static_cast<int>(2 * half_deg_ / step_deg);
            const int phase = (ping_ - first_ping_) % (2 * per_sweep);
            const double bearing = -half_deg_ + step_deg * (phase < per_sweep ? phase : 2 * per_sweep - phase);
            BeamMoment beam;
            beam.time = Timestamp(microsecondsFromSeconds(t));
            beam.azimuth = Bearing::degrees(bearing);
            beam.step_rad = radiansFromDegrees(step_deg);
            beam.beam_width_rad = radiansFromDegrees(3);
            beam.far_m = 50;
            beam.range_scale_m = 50;
            beam.point_length_m = 0.5;
            beam.turned_round = beam.sweep_ended = ping_ > first_ping_ && (phase == 1 || phase == per_sweep + 1);
            beam.navigation_known = true;
            if (half_deg_ < half_sector_deg)
                beam.watched =
                    WatchedSector{{}, radiansFromDegrees(half_deg_), radiansFromDegrees(2 * half_sector_deg)};
            if (disturbed_) beam.*std::exchange(disturbed_, nullptr) = true;

            std::vector<Region> due;
            std::swap(due, later_);
            std::swap(later_, next_);
            for (const Object& object : objects_) {
                const Eigen::Vector2d place = object.at(t);
                const double turn = degreesFromRadians(std::atan2(place.y(), place.x())) - bearing;
                if (std::abs(turn) <= step_deg / 2 && object.shows(t)) next_.push_back(regionAt(place, object, t));
            }
            tracker.update(
                beam, due, [](double, double) { return false; }, looks);
        }
    }

    /// From here on the head scans so much to each side, of ±45°.
    void scan(double half_deg) {
        half_deg_ = half_deg;
        first_ping_ = ping_;
    }
    std::optional<Track> track(int id) const {
        for (const Track& track : tracker.tracks())
            if (track.id == id) return track;
        return std::nullopt;
    }

    Tracker tracker;
    std::vector<TrackLook> looks;

    std::vector<TrackLook> confirmedLooks() const {
        std::vector<TrackLook> found;
        for (const TrackLook& look : looks)
            if (look.state == TrackState::Confirmed) found.push_back(look);
        return found;
    }
    const Object& object(std::size_t i) const { return objects_[i]; }
    /// What is wrong with the next ping.
    void disturb(bool BeamMoment::*what) { disturbed_ = what; }

private:
    Region regionAt(const Eigen::Vector2d& place, const Object& object, double t) {
        Region region;
        region.id = ++id_;
        region.time = Timestamp(microsecondsFromSeconds(t));
        region.position_m = place + 0.1 * Eigen::Vector2d(noise_.gaussian(), noise_.gaussian());
        region.range_m = region.position_m.norm();
        region.bearing = Bearing::radians(std::atan2(region.position_m.y(), region.position_m.x()));
        region.beam_hits = 3;
        // What an ellipse of these widths would give: M2 = [(e − 1/e)/4π]², e = across/along.
        const double along = 0.6, across = object.area_m2 / (M_PI / 4 * along), e = across / along;
        region.contrast_db = object.strength_db;
        region.peak_db = object.peak_db;
        region.features = {.area_m2 = object.area_m2,
                           .moment = std::log10(std::pow((e - 1 / e) / (4 * M_PI), 2) + 1e-3),
                           .along_range_m = along,
                           .across_range_m = across,
                           .strength_db = object.strength_db,
                           .level_db = object.peak_db};
        return region;
    }
    std::vector<Object> objects_;
    RandomStream noise_;
    std::vector<Region> later_, next_;
    int ping_ = 0, first_ping_ = 0;  ///< the first one of the sector that is scanned
    double half_deg_ = half_sector_deg;
    bool BeamMoment::*disturbed_ = nullptr;
    std::uint32_t id_ = 0;
};

double secondsOf(const TrackLook& look) { return secondsBetween(Timestamp{}, look.time); }

TEST(Tracker, ConfirmsAMovingTargetAndFollowsItWithOneId) {
    Scene scene({{{25, 3}, {-0.3, 0.1}}});
    scene.run(60);
    const auto confirmed = scene.confirmedLooks();
    ASSERT_GE(confirmed.size(), 8u);
    for (const TrackLook& look : confirmed) {
        EXPECT_EQ(look.track, confirmed.front().track);
        if (look.seen) {
            EXPECT_LT((look.position_m - scene.object(0).at(secondsOf(look))).norm(), 0.6) << secondsOf(look);
        }
        EXPECT_GT(look.covariance_m2.determinant(), 0);
    }
    EXPECT_NEAR(confirmed.back().velocity_mps.x(), -0.3, 0.1);
    EXPECT_EQ(scene.tracker.confirmedEver(), 1u);
}

TEST(Tracker, EachPassGivesOneLookAndAMissIsSaidToBeUnseen) {
    Scene scene({{{20, 0}, {0, 0}, 0.6, 0, 30, 1e9}});
    scene.run(48);
    int unseen = 0;
    for (std::size_t i = 1; i < scene.looks.size(); ++i) {
        EXPECT_NEAR(secondsOf(scene.looks[i]) - secondsOf(scene.looks[i - 1]), 5.0, 0.6);
        unseen += !scene.looks[i].seen;
    }
    EXPECT_GE(unseen, 3);
    EXPECT_EQ(scene.looks.back().state, TrackState::Coasting);
}

TEST(Tracker, ALookWithoutAnEchoSaysWhy) {
    // Hidden from 30 s on: nothing stands out where the beam passes.
    Scene hidden({{{20, 0}, {0, 0}, 0.6, 0, 30, 1e9}});
    hidden.run(48);
    for (const TrackLook& look : hidden.looks)
        EXPECT_EQ(look.no_echo, look.seen ? NoEcho::None : NoEcho::UnderThreshold) << secondsOf(look);
    // The same when pings or poses are missing at 32 s: the first look afterwards says so.
    for (const auto& [missing, cause] : {std::pair(&BeamMoment::pings_missing, NoEcho::PingsMissing),
                                         std::pair(&BeamMoment::navigation_gap, NoEcho::NavigationGap)}) {
        Scene scene({{{20, 0}, {0, 0}, 0.6, 0, 30, 1e9}});
        scene.run(32);
        scene.disturb(missing);
        scene.run(44);
        std::vector<NoEcho> causes;
        for (const TrackLook& look : scene.looks)
            if (!look.seen) causes.push_back(look.no_echo);
        ASSERT_GE(causes.size(), 2U);
        EXPECT_EQ(std::count(causes.begin(), causes.end(), cause), 1);
        EXPECT_EQ(causes.back(), NoEcho::UnderThreshold);
    }
}

TEST(Tracker, WhatTheSectorLeavesBehindIsLostForThat) {
    Scene scene({{{20, 14}, {0, 0.3}}});
    scene.run(90);
    ASSERT_EQ(scene.looks.back().state, TrackState::Lost);
    EXPECT_EQ(scene.looks.back().no_echo, NoEcho::OutsideSector);
    const auto tracks = scene.tracker.tracks();
    const auto lost = std::find_if(tracks.begin(), tracks.end(),
                                   [&](const Track& track) { return track.id == scene.looks.back().track; });
    ASSERT_NE(lost, tracks.end());
    EXPECT_EQ(lost->history.back().no_echo, NoEcho::OutsideSector) << "whoever looks at the track is told as well";
}

TEST(Tracker, LostTargetIsFoundAgainUnderItsOldId) {
    Scene scene({{{20, 0}, {0, 0}, 0.6, 0, 40, 75}});
    scene.run(120);
    bool lost = false;
    for (const TrackLook& look : scene.looks) lost |= look.state == TrackState::Lost;
    EXPECT_TRUE(lost);
    EXPECT_EQ(scene.looks.back().state, TrackState::Confirmed);
    EXPECT_EQ(scene.looks.back().track, scene.looks.front().track);
    EXPECT_EQ(scene.tracker.confirmedEver(), 1u);
}

TEST(Tracker, OneFalseEchoStartsNothingThatLasts) {
    Scene scene({{{30, 5}, {0, 0}, 0.6, 0, 4, 1e9}});
    scene.run(60);
    EXPECT_TRUE(scene.confirmedLooks().empty());
    EXPECT_TRUE(scene.tracker.tracks().empty());
}

TEST(Tracker, TargetOutsideTheSectorIsNotMissed) {
    // It leaves to starboard at about 25 s; nobody looks there any more, until it is given up for its age.
    Scene scene({{{20, 14}, {0, 0.3}}});
    scene.run(45);
    for (const TrackLook& look : scene.looks)
        if (!look.seen) {
            EXPECT_NE(look.state, TrackState::Lost);
        }
}

TEST(Tracker, WhatAHeadThatFollowsDoesNotLookAtIsNeitherMissedNorLost) {
    Scene scene({{{20, 0}}, {{25, 14}}});
    scene.run(25);
    ASSERT_EQ(scene.tracker.confirmedEver(), 2u);
    const int ahead = scene.looks[0].track, aside = scene.looks[1].track;
    ASSERT_NE(ahead, aside);
    scene.scan(9);
    scene.run(60);
    for (const int id : {ahead, aside}) {
        const auto track = scene.track(id);
        ASSERT_TRUE(track) << id;
        EXPECT_EQ(track->state, TrackState::Confirmed) << id;
        EXPECT_EQ(track->misses, 0) << id;
    }
    scene.scan(half_sector_deg);
    scene.run(75);
    for (const int id : {ahead, aside}) {
        const auto track = scene.track(id);
        ASSERT_TRUE(track) << id;
        EXPECT_EQ(track->state, TrackState::Confirmed) << id;
        EXPECT_GT(secondsBetween(Timestamp{}, track->last_seen), 65) << "seen again under its own number: " << id;
    }
}

TEST(Tracker, WhatGoesBySweepsGoesNoFasterWhereTheHeadFollows) {
    Scene open({{{20, 0}}}), closed({{{20, 0}}});
    for (Scene* scene : {&open, &closed}) scene->run(25);
    closed.scan(9);
    for (Scene* scene : {&open, &closed}) scene->run(100);
    EXPECT_NEAR(closed.tracker.clutterDensity(), open.tracker.clutterDensity(), 0.3 * open.tracker.clutterDensity());
}

TEST(Tracker, CrossingTargetsKeepTheirIdentity) {
    int kept = 0;
    constexpr int runs = 20;
    for (int run = 0; run < runs; ++run) {
        Scene scene({{{20, -9}, {0, 0.3}}, {{23, 9}, {0, -0.3}}}, {}, 100 + run);
        scene.run(60);
        std::map<int, int> first_owner;
        bool switched = false;
        for (const TrackLook& look : scene.confirmedLooks()) {
            if (!look.seen) continue;
            const int nearest = (look.position_m - scene.object(0).at(secondsOf(look))).norm() <
                                        (look.position_m - scene.object(1).at(secondsOf(look))).norm()
                                    ? 0
                                    : 1;
            const auto [owner, is_new] = first_owner.try_emplace(look.track, nearest);
            switched |= owner->second != nearest;
        }
        kept += !switched && first_owner.size() == 2;
    }
    EXPECT_GE(kept, 19);
}

TEST(Tracker, AnEchosCopyBehindItStartsNoTrack) {
    const std::vector<Object> echo_and_copy{{{20, 0}, {0, 0}}, {{22, 0}, {0, 0}, 0.6, 0, 1e9, 1e9, 50}};
    Scene scene(echo_and_copy);
    scene.run(60);
    EXPECT_EQ(scene.tracker.confirmedEver(), 1u);
    for (const TrackLook& look : scene.confirmedLooks()) EXPECT_NEAR(look.position_m.x(), 20.0, 0.6);
    Tracker::Params without;
    without.tracking.ghost_density = 0;
    Scene both(echo_and_copy, without);
    both.run(60);
    EXPECT_EQ(both.tracker.confirmedEver(), 2u);
}

TEST(Tracker, WhatASideLobeHearsStartsNoTrack) {
    const std::vector<Object> strong_and_lobe{{.start = {20, 0}, .peak_db = 75}, {.start = {18.1, 8.5}, .peak_db = 40}};
    Scene scene(strong_and_lobe);
    scene.run(60);
    EXPECT_EQ(scene.tracker.confirmedEver(), 1u);
    Tracker::Params without;
    without.tracking.side_lobe_db = 80;
    Scene both(strong_and_lobe, without);
    both.run(60);
    EXPECT_EQ(both.tracker.confirmedEver(), 2u);
}

TEST(Tracker, AThinArcAboutTheHeadStartsNoTrack) {
    Scene arc({{.start = {20, 0}, .area_m2 = 2.0}});  // 0.6 m along the line of sight, 4.2 m across it
    arc.run(60);
    EXPECT_EQ(arc.tracker.confirmedEver(), 0u);
    arc.tracker.designate({20, 0}, 3.0);
    arc.run(90);
    EXPECT_EQ(arc.tracker.confirmedEver(), 1u) << "the operator knows better";
}

TEST(Tracker, EchoesThatRunIntoEachOtherCountForBothTracks) {
    constexpr double merge_s = 40;
    Scene scene(
        {{{20, -0.8}, {0, 0}, 0.6, 0, merge_s}, {{20, 0.8}, {0, 0}, 0.6, 0, merge_s}, {{20, 0}, {0, 0}, 1.6, merge_s}});
    scene.run(merge_s);
    ASSERT_EQ(scene.tracker.confirmedEver(), 2u);
    scene.run(merge_s + 40);
    std::map<int, int> seen;
    for (const TrackLook& look : scene.confirmedLooks())
        if (secondsOf(look) > merge_s) seen[look.track] += look.seen;
    ASSERT_EQ(seen.size(), 2u);
    for (const auto& [track, looks] : seen) EXPECT_GE(looks, 3) << track;  // then the younger is taken for a double
}

TEST(Tracker, PickBeforeTheTargetShowsWaitsForIt) {
    Scene scene({{{20, 0}, {0, 0}, 0.6, 12}, {{30, 10}, {0, 0}}});
    scene.tracker.designate({20.5, 0.5}, 3.0);
    scene.run(40);
    for (const TrackLook& look : scene.looks)
        EXPECT_EQ(look.target, (look.position_m - Eigen::Vector2d(20, 0)).norm() < 3);
}

TEST(Tracker, PickIsOfTheStrongerThingThatShowsASweepLater) {
    const Object wake{.start = {20, 0}, .strength_db = 15};
    const Object body{.start = {21, 1.6}, .visible_from_s = 4, .strength_db = 40};
    Scene scene({wake, body});
    scene.tracker.designate({20.7, 1.0}, 5.0);
    scene.run(4);
    ASSERT_EQ(scene.tracker.tracks().size(), 1u);
    EXPECT_TRUE(scene.tracker.tracks().front().target);
    scene.run(60);
    ASSERT_EQ(scene.tracker.tracks().size(), 2u);
    for (const Track& track : scene.tracker.tracks())
        EXPECT_EQ(track.target, (track.estimate.mean.head<2>() - body.start).norm() < 0.8);
}

TEST(Tracker, PointingAtALostTargetFindsItUnderItsOldId) {
    Scene scene({{.start = {20, 0}, .hidden_from_s = 40, .shown_again_s = 90}});
    scene.tracker.designate({20, 0}, 5.0);
    scene.run(80);
    const auto target = [&] {
        for (const Track& track : scene.tracker.tracks())
            if (track.target) return track;
        return Track{};
    };
    const int id = target().id;
    ASSERT_EQ(target().state, TrackState::Lost);
    scene.tracker.designate({20.5, 0.5}, 3.0);
    EXPECT_EQ(target().id, id);
    EXPECT_LT((target().estimate.mean.head<2>() - Eigen::Vector2d(20.5, 0.5)).norm(), 1e-9);
    scene.run(110);
    EXPECT_EQ(target().id, id);
    EXPECT_EQ(target().state, TrackState::Confirmed);
}

TEST(Tracker, ADroppedTrackIsToldOfNoMoreAndKeepsItsEchoesUntilItIsTakenBack) {
    Scene scene({{.start = {20, 0}}, {.start = {30, 8}}});
    scene.run(60);
    ASSERT_EQ(scene.tracker.tracks().size(), 2u);
    const Track dropped = scene.tracker.tracks().front();
    const Eigen::Vector2d place = dropped.estimate.mean.head<2>();
    EXPECT_FALSE(scene.tracker.drop(dropped.id, place + Eigen::Vector2d(0, 9), 3.0)) << "another object's number";
    EXPECT_TRUE(scene.tracker.drop(dropped.id, place, 3.0));
    scene.looks.clear();
    scene.run(120);
    ASSERT_EQ(scene.tracker.tracks().size(), 1u) << "and nothing began on its echoes";
    for (const TrackLook& look : scene.looks) EXPECT_NE(look.track, dropped.id);
    EXPECT_FALSE(scene.looks.empty());

    scene.tracker.restore(dropped.id);
    ASSERT_EQ(scene.tracker.tracks().size(), 2u);
    EXPECT_EQ(scene.tracker.tracks().front().state, TrackState::Confirmed);
    ASSERT_TRUE(scene.tracker.drop(dropped.id, place, 3.0));
    scene.tracker.designate(place, 3.0);
    EXPECT_FALSE(scene.tracker.isDropped(dropped.id)) << "who points at it wants it";
}

TEST(Tracker, SameSeedSameBitsOtherSeedOthers) {
    const auto positions = [](std::uint64_t filter_seed) {
        Scene scene({{{25, 3}, {-0.3, 0.1}}, {{15, -3}, {0.1, 0.2}}}, {}, 5);
        scene.tracker = Tracker({}, filter_seed);
        scene.run(40);
        std::vector<double> values;
        for (const TrackLook& look : scene.looks) values.push_back(look.position_m.x());
        return values;
    };
    EXPECT_EQ(positions(1), positions(1));
    EXPECT_NE(positions(1), positions(2));
}

TEST(Tracker, NeverFollowsMoreThanItMay) {
    std::vector<Object> crowd;
    for (int i = 0; i < 40; ++i) crowd.push_back({{10.0 + i, (i % 5) * 2.0 - 4.0}, {0, 0}});
    Tracker::Params params;
    params.tracking.max_tracks = 12;
    Scene scene(crowd, params);
    scene.run(40);
    EXPECT_LE(scene.tracker.tracks().size(), 12u);
    EXPECT_GE(scene.tracker.tracks().size(), 10u);
}

}  // namespace
}  // namespace echotrail
