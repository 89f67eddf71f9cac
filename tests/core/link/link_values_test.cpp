#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echotrail {
namespace {

using namespace test;

/// Over the wire and back.
template <class Message>
Message carried(const Message& message) {
    Message copy;
    EXPECT_TRUE(copy.ParseFromString(message.SerializeAsString()));
    return copy;
}

template <class Message, class Value, class... More>
auto roundTrip(const Value& value, More... more) {
    Message message;
    write(value, more..., message);
    return read(carried(message));
}

void expectEqual(const RegionFeatures& a, const RegionFeatures& b) {
    EXPECT_EQ(a.area_m2, b.area_m2);
    EXPECT_EQ(a.moment, b.moment);
    EXPECT_EQ(a.along_range_m, b.along_range_m);
    EXPECT_EQ(a.across_range_m, b.across_range_m);
    EXPECT_EQ(a.strength_db, b.strength_db);
    EXPECT_EQ(a.level_db, b.level_db);
}

void expectEqual(const TrackLook& a, const TrackLook& b) {
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.track, b.track);
    EXPECT_EQ(a.state, b.state);
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.seen, b.seen);
    EXPECT_EQ(a.no_echo, b.no_echo);
    EXPECT_EQ(a.range_m, b.range_m);
    EXPECT_EQ(a.bearing, b.bearing);
    EXPECT_EQ(a.position_m, b.position_m);
    EXPECT_EQ(a.velocity_mps, b.velocity_mps);
    EXPECT_EQ(a.covariance_m2, b.covariance_m2);
}

TEST(LinkValues, ABeamComesThroughToTheLastBit) {
    const LinkBeam sent = sampleBeam();
    const auto back = roundTrip<wire::Beam>(sent, std::size_t{1});
    ASSERT_TRUE(back);
    EXPECT_EQ(back->ping, sent.ping);
    EXPECT_EQ(back->update.ping, sent.update.ping);
    EXPECT_EQ(back->update.time, sent.update.time);
    EXPECT_EQ(back->update.pose, sent.update.pose);
    EXPECT_EQ(back->update.later_pose, sent.update.later_pose);
    EXPECT_EQ(back->update.beam, sent.update.beam);
    EXPECT_TRUE(back->update.navigation_gap && back->update.broke_off && back->update.sweep_ended);
    EXPECT_EQ(back->update.sweep, 4U);
    EXPECT_DOUBLE_EQ(back->mount.mount_heading_deg, 5.0);
    EXPECT_EQ(back->mount.mount_forward_m, 0.5);
    EXPECT_EQ(back->mount.mount_starboard_m, -0.25);
    EXPECT_TRUE(back->mount.mount_inverted && back->navigation_known);
    EXPECT_EQ(back->first_ping, sent.first_ping);
}

TEST(LinkValues, LessDetailKeepsTheStrongestAndTheRange) {
    LinkBeam sent = sampleBeam();
    sent.ping.levels = {1, 9, 3, 4, 7, 2, 5};
    const auto half = roundTrip<wire::Beam>(sent, std::size_t{2});
    ASSERT_TRUE(half);
    EXPECT_EQ(half->ping.levels, (std::vector<std::uint8_t>{9, 4, 7, 5}));
    EXPECT_DOUBLE_EQ(half->ping.binSize(), 2.0 * sent.ping.binSize());
    const auto none = roundTrip<wire::Beam>(sent, std::size_t{0});
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->ping.levels.empty());
    EXPECT_EQ(none->update.pose, sent.update.pose) << "where the vehicle is stays known";
}

TEST(LinkValues, ARegionComesThrough) {
    const Region sent = sampleRegion();
    const auto back = roundTrip<wire::Region>(sent);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->id, sent.id);
    EXPECT_EQ(back->time, sent.time);
    EXPECT_EQ(back->position_m, sent.position_m);
    EXPECT_EQ(back->head, sent.head);
    EXPECT_EQ(back->range_m, sent.range_m);
    EXPECT_EQ(back->bearing, sent.bearing);
    expectEqual(back->features, sent.features);
    EXPECT_EQ(back->peak_db, sent.peak_db);
    EXPECT_EQ(back->mean_db, sent.mean_db);
    EXPECT_EQ(back->contrast_db, sent.contrast_db);
    EXPECT_EQ(back->pixels, sent.pixels);
    EXPECT_EQ(back->beam_hits, sent.beam_hits);
    EXPECT_EQ(back->clipped_fraction, sent.clipped_fraction);
    EXPECT_TRUE(back->only_expected && back->clutter_mass && back->multipath);
    EXPECT_EQ(back->outline_m, sent.outline_m);
}

TEST(LinkValues, ATrackComesThroughWithItsHistory) {
    const Track sent = sampleTrack();
    const auto back = roundTrip<wire::Track>(sent, true);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->id, sent.id);
    EXPECT_EQ(back->state, sent.state);
    EXPECT_EQ(back->target, sent.target);
    EXPECT_EQ(back->estimate.time, sent.estimate.time);
    EXPECT_EQ(back->estimate.mean, sent.estimate.mean);
    EXPECT_EQ(back->estimate.covariance, sent.estimate.covariance);
    EXPECT_EQ(back->born, sent.born);
    EXPECT_EQ(back->last_seen, sent.last_seen);
    EXPECT_EQ(back->existence, sent.existence);
    EXPECT_EQ(back->looks, sent.looks);
    EXPECT_EQ(back->misses, sent.misses);
    EXPECT_EQ(back->score, sent.score);
    EXPECT_EQ(back->innovation_m, sent.innovation_m);
    EXPECT_EQ(back->nis, sent.nis);
    expectEqual(back->seen_features, sent.seen_features);
    expectEqual(back->expected_features, sent.expected_features);
    EXPECT_EQ(back->region_of_interest.centre, sent.region_of_interest.centre);
    EXPECT_EQ(back->region_of_interest.far_m, sent.region_of_interest.far_m);
    ASSERT_EQ(back->history.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) expectEqual(back->history[i], sent.history[i]);
    EXPECT_TRUE(roundTrip<wire::Track>(sent, false)->history.empty());
}

TEST(LinkValues, ACauseThatOnlyANewerTrackerKnowsIsNone) {
    wire::Look look;
    write(sampleLook(), look);
    EXPECT_EQ(read(carried(look))->no_echo, NoEcho::TakenByAnother);
    for (const int unknown : {no_echo_causes, 99, -1}) {
        look.set_no_echo(unknown);
        EXPECT_EQ(read(carried(look))->no_echo, NoEcho::None) << unknown;
    }
}

TEST(LinkValues, ParticlesAreThinnedAndTheirWeightsAddUpToOne) {
    wire::Particles message;
    write(2, sampleTrack().particles, 200, *message.add_clouds());
    const auto back = read(carried(message));
    ASSERT_TRUE(back && back->clouds.size() == 1);
    const ParticleCloud& cloud = back->clouds[0].second;
    EXPECT_EQ(cloud.position_m.size(), 200U);
    double sum = 0.0;
    for (const float weight : cloud.weight) sum += static_cast<double>(weight);
    EXPECT_NEAR(sum, 1.0, 1e-5);
    EXPECT_EQ(cloud.effective, 800.0);
    EXPECT_EQ(cloud.size(), sampleTrack().particles.size());  // of all: the effective number is of all, too
}

TEST(LinkValues, HealthComesThrough) {
    const LinkHealth sent = sampleHealth();
    const auto back = roundTrip<wire::Health>(sent);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->time, sent.time);
    EXPECT_EQ(back->sonar, sent.sonar);
    EXPECT_EQ(back->navigation, sent.navigation);
    EXPECT_EQ(back->head_state, 5U);
    EXPECT_EQ(back->head + back->head_advice + back->head_difference, "SeaKing DFS, node 2look at the cablerange");
    EXPECT_EQ(back->head_confirmed, sent.head_confirmed);
    EXPECT_EQ(back->head_pings + back->head_timeouts + back->head_retries + back->head_resets + back->head_rejected,
              15U);
    EXPECT_EQ(back->pings + back->skipped + back->sweeps + back->confirmed + back->without_pose, 40U);
    EXPECT_EQ(back->counts.rejected, sent.counts.rejected);
    EXPECT_EQ(back->counts.lost_records, 12U);
    EXPECT_EQ(back->counts.skipped_bytes, 13U);
    EXPECT_EQ(back->queued, 14U);
    EXPECT_EQ(back->lag_s, 0.25);
    EXPECT_EQ(back->processing_s, 1.5);
    EXPECT_EQ(back->last_ping, sent.last_ping);
    EXPECT_EQ(back->heading_kind + back->position_kind, "HDTGGA");
    EXPECT_EQ(back->heading_time, sent.heading_time);
    EXPECT_EQ(back->heading, sent.heading);
    EXPECT_TRUE(back->recording);
    EXPECT_EQ(back->log_path + back->log_error, "/data/a.echotrailfull");
    EXPECT_EQ(back->log_bytes + back->free_bytes + back->unsaved, 48U);
    EXPECT_EQ(back->disk, 1U);
    EXPECT_EQ(back->microseconds_per_ping, 45.0);
}

TEST(LinkValues, WhatCannotBeIsRefused) {
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    wire::Beam good;
    write(sampleBeam(), 1, good);
    ASSERT_TRUE(read(good));
    const auto refused = [&](auto change) {
        wire::Beam bad = good;
        change(bad);
        return !read(bad);
    };
    EXPECT_TRUE(refused([&](auto& b) { b.set_bearing_rad(not_a_number); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_time_us(-1); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_time_us(std::numeric_limits<std::int64_t>::max()); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_range_scale_m(0.0); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_range_scale_m(1e9); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_bin_interval_s(-1.0); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_bin_interval_s(10.0); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_step_rad(0.0); }));
    EXPECT_TRUE(refused([&](auto& b) { b.set_levels(std::string(100'000, 'x')); }));
    EXPECT_TRUE(refused([&](auto& b) { b.mutable_vehicle()->set_north_m(1e300); }));
    EXPECT_TRUE(refused([&](auto& b) { b.mutable_vehicle_later()->set_north_m(5000.0); })) << "nobody is so fast";
    EXPECT_TRUE(refused([&](auto& b) { b.mutable_mount()->set_forward_m(not_a_number); }));

    wire::Track track;
    write(sampleTrack(), true, track);
    ASSERT_TRUE(read(track));
    const auto bad_track = [&](auto change) {
        wire::Track bad = track;
        change(bad);
        return !read(bad);
    };
    EXPECT_TRUE(bad_track([&](auto& t) { t.set_mean(0, not_a_number); }));
    EXPECT_TRUE(bad_track([&](auto& t) { t.add_mean(0.0); }));
    EXPECT_TRUE(bad_track([&](auto& t) { t.set_covariance(0, -1.0); }));
    EXPECT_TRUE(bad_track([&](auto& t) { t.clear_covariance(); }));
    EXPECT_TRUE(bad_track([&](auto& t) { t.set_state(static_cast<wire::TrackState>(9)); }));
    EXPECT_TRUE(bad_track([&](auto& t) {
        for (int i = 0; i < 300; ++i) *t.add_history() = t.history(0);
    }));

    wire::Region region;
    write(sampleRegion(), region);
    region.add_outline_m(1.0F);
    EXPECT_FALSE(read(region)) << "half a point";

    wire::Parameter parameter;
    parameter.set_name("x");
    EXPECT_FALSE(read(parameter)) << "without a value";
    parameter.set_whole(1LL << 40);
    EXPECT_FALSE(read(parameter));
    parameter.set_real(not_a_number);
    EXPECT_FALSE(read(parameter));
    parameter.set_word(std::string(10'000, 'x'));
    EXPECT_FALSE(read(parameter));
}

TEST(LinkValues, TextIsShownOnOneLineAndCutBetweenCharacters) {
    EXPECT_EQ(cleanText("a\nb\x1b[31m", 100), "a b [31m");
    EXPECT_EQ(cleanText("aé", 2), "a");
    EXPECT_EQ(cleanText("aé", 3), "aé");
    EXPECT_EQ(cleanText("a\xff\xc3", 100), "a??") << "a path may hold any bytes, a message may not";
    EXPECT_EQ(cleanText("\xc0\x80\xed\xa0\x80\xf4\x90\x80\x80", 100).find_first_not_of('?'), std::string::npos);
    EXPECT_EQ(cleanText("\U0001F6A4", 4), "\U0001F6A4");
}

}  // namespace
}  // namespace echotrail
