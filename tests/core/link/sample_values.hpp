#pragma once

#include "core/link/link_values.hpp"

#include <cmath>
#include <vector>

namespace echotrail::test {

inline Timestamp at(double seconds) {
    return Timestamp(std::chrono::seconds(1'600'000'000)) + microsecondsFromSeconds(seconds);
}

/// Every field of it differs from its default.
inline LinkBeam sampleBeam(std::uint64_t number = 7, double seconds = 3.5) {
    LinkBeam beam;
    beam.ping.sequence = number;
    beam.ping.time = at(seconds);
    beam.ping.bearing = Bearing::degrees(-12.6);
    beam.ping.step_rad = radiansFromDegrees(1.8);
    beam.ping.range_scale_m = 50.0;
    beam.ping.bin_interval_s = 0.0001;
    beam.ping.sound_speed_mps = 1490.0;
    beam.ping.frequency_hz = 675e3;
    beam.ping.gain_percent = 40.0;
    beam.ping.clockwise = false;
    for (int i = 0; i < 400; ++i) beam.ping.levels.push_back(static_cast<std::uint8_t>(i * 37 % 256));
    beam.update.ping = number;
    beam.update.time = beam.ping.time;
    beam.update.pose = {10.0, -20.0, Bearing::degrees(30.0)};
    beam.update.later_pose = {10.05, -20.02, Bearing::degrees(30.1)};
    beam.update.beam = Bearing::degrees(-11.0);
    beam.update.navigation_gap = true;
    beam.update.broke_off = true;
    beam.update.sweep = 4;
    beam.update.sweep_ended = true;
    beam.mount.mount_heading_deg = 5.0;
    beam.mount.mount_forward_m = 0.5;
    beam.mount.mount_starboard_m = -0.25;
    beam.mount.mount_inverted = true;
    beam.first_ping = at(0.0);
    beam.navigation_known = true;
    return beam;
}

inline Region sampleRegion(std::uint32_t id = 3, double seconds = 3.25) {
    Region region;
    region.id = id;
    region.time = at(seconds);
    region.position_m = {12.5, -8.25};
    region.head = {1.0, 2.0, Bearing::degrees(45.0)};
    region.range_m = 15.0;
    region.bearing = Bearing::degrees(-20.0);
    region.features = {1.25, -0.7, 0.5, 0.75, 18.0, 61.0};
    region.peak_db = 60.0;
    region.mean_db = 50.0;
    region.contrast_db = 20.0;
    region.pixels = 44;
    region.beam_hits = 3;
    region.clipped_fraction = 0.125;
    region.only_expected = region.clutter_mass = region.multipath = true;
    region.outline_m = {{1.0F, 2.0F}, {3.0F, 4.5F}, {-1.0F, 0.25F}};
    return region;
}

inline TrackLook sampleLook(int track = 2, double seconds = 3.0) {
    TrackLook look;
    look.time = at(seconds);
    look.track = track;
    look.state = TrackState::Coasting;
    look.target = true;
    look.no_echo = NoEcho::TakenByAnother;
    look.range_m = 20.0;
    look.bearing = Bearing::degrees(10.0);
    look.position_m = {19.0, 3.0};
    look.velocity_mps = {-0.5, 0.25};
    look.covariance_m2 << 0.5, 0.1, 0.1, 0.75;
    return look;
}

inline Track sampleTrack(int id = 2, double seconds = 3.0, int particles = 1000) {
    Track track;
    track.id = id;
    track.state = TrackState::Confirmed;
    track.target = true;
    track.estimate.time = at(seconds);
    track.estimate.mean << 19.0, 3.0, -0.5, 0.25;
    track.estimate.covariance << 0.5, 0.1, 0.01, 0.02, 0.1, 0.75, 0.03, 0.04, 0.01, 0.03, 0.2, 0.05, 0.02, 0.04, 0.05,
        0.3;
    track.born = at(0.5);
    track.last_seen = at(seconds);
    track.existence = 0.875;
    track.looks = 5;
    track.misses = 1;
    track.score = 0.75;
    track.innovation_m = 0.3;
    track.nis = 1.5;
    track.seen_features = {1.0, -0.5, 0.4, 0.6, 17.0, 60.0};
    track.expected_features = {1.1, -0.6, 0.45, 0.65, 16.0, 59.0};
    track.region_of_interest = {1.0, 2.0, Bearing::degrees(5.0), 0.25, 15.0, 25.0};
    for (int i = 0; i < particles; ++i) {
        track.particles.position_m.emplace_back(19.0F + 0.001F * static_cast<float>(i), 3.0F);
        track.particles.weight.push_back(1.0F / static_cast<float>(particles));
    }
    track.particles.effective = 800.0;
    track.history = {sampleLook(id, seconds - 2.0), sampleLook(id, seconds)};
    return track;
}

inline LinkHealth sampleHealth(double seconds = 3.0) {
    LinkHealth health;
    health.time = at(seconds);
    health.sonar = {true, "", 0.5};
    health.navigation = LinkEnd{false, "no answer", std::nullopt};
    health.head_state = 5;
    health.head = "SeaKing DFS, node 2";
    health.head_advice = "look at the cable";
    health.head_difference = "range";
    health.head_confirmed = {
        {"range_m", 50.0}, {"channel", std::string("high")}, {"bits", 8}, {"mount_inverted", true}};
    health.head_pings = 1;
    health.head_timeouts = 2;
    health.head_retries = 3;
    health.head_resets = 4;
    health.head_rejected = 5;
    health.pings = 6;
    health.skipped = 7;
    health.sweeps = 8;
    health.confirmed = 9;
    health.without_pose = 10;
    health.counts.rejected = {{"bad_length", 11}};
    health.counts.lost_records = 12;
    health.counts.skipped_bytes = 13;
    health.queued = 14;
    health.lag_s = 0.25;
    health.processing_s = 1.5;
    health.last_ping = at(2.75);
    health.heading_kind = "HDT";
    health.position_kind = "GGA";
    health.heading_time = at(2.5);
    health.heading = Bearing::degrees(123.0);
    health.recording = true;
    health.log_path = "/data/a.echotrail";
    health.log_error = "full";
    health.log_bytes = 15;
    health.free_bytes = 16;
    health.unsaved = 17;
    health.disk = 1;
    health.microseconds_per_ping = 45.0;
    return health;
}

inline std::vector<NamedValue> sampleParameters() {
    return {{"range_m", 50.0}, {"particles", 2000}, {"mount_inverted", false}, {"channel", std::string("high")}};
}

/// A moment aboard: a beam of a scan to and fro, a region and tracks that change with every ping.
inline LinkMoment sampleMoment(std::uint64_t number, double seconds, int tracks = 1) {
    LinkMoment moment;
    moment.time = at(seconds);
    moment.beam = sampleBeam(number, seconds);
    moment.beam->update.sweep = number / 20;
    moment.beam->update.sweep_ended = number % 20 == 0;
    moment.beam->update.broke_off = false;
    moment.regions = {sampleRegion(static_cast<std::uint32_t>(number), seconds)};
    for (int id = 1; id <= tracks; ++id) {
        moment.tracks.push_back(sampleTrack(id, seconds));
        moment.looks.push_back(sampleLook(id, seconds));
    }
    return moment;
}

}  // namespace echotrail::test
