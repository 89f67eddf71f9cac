#include "core/pipelines/scanning_sonar_pipeline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

namespace echotrail {
namespace {

constexpr int bins = 500;
constexpr double range_m = 50.0, sound_speed = 1500.0, ping_s = 0.1, step_deg = 1.8;

/// A quiet sea with a compact echo at a place; ±45° scanned to and fro.
std::vector<Ping> scanOf(double north, double east, double north_speed, int pings) {
    std::vector<Ping> all;
    RandomStream random(9, 0, 0);
    for (int i = 0; i < pings; ++i) {
        Ping ping;
        ping.sequence = static_cast<std::uint64_t>(i);
        ping.time = Timestamp(microsecondsFromSeconds(i * ping_s));
        const int phase = i % 100;
        const double bearing = -45 + step_deg * (phase < 50 ? phase : 100 - phase);
        ping.bearing = Bearing::degrees(bearing);
        ping.step_rad = radiansFromDegrees(step_deg);
        ping.range_scale_m = range_m;
        ping.sound_speed_mps = sound_speed;
        ping.bin_interval_s = 2 * range_m / sound_speed / bins;
        ping.frequency_hz = 325e3;
        const double n = north + north_speed * i * ping_s;
        const double range = std::hypot(n, east), off = degreesFromRadians(std::atan2(east, n)) - bearing;
        for (int bin = 0; bin < bins; ++bin) {
            const double r = (bin + 0.5) * range_m / bins;
            const double echo_db = 40 - 12 * std::pow(off / 1.5, 2) - 4 * std::pow((r - range) / 0.2, 2);
            const double noise_db = 12 + 10 * std::log10(-std::log(random.uniform()));
            const double db = std::max(echo_db, noise_db);
            ping.levels.push_back(static_cast<std::uint8_t>(std::clamp(db * levels_per_db, 0.0, 255.0)));
        }
        all.push_back(std::move(ping));
    }
    return all;
}

std::vector<TrackLook> run(const std::vector<Ping>& pings, const ScanningSonarPipeline::Params& params = {},
                           const PoseHistory& navigation = {}, bool paint = true) {
    ScanningSonarPipeline pipeline(params, 1);
    pipeline.setFanPainting(paint);
    std::vector<TrackLook> looks;
    const auto collect = [&](const Update& update) {
        looks.insert(looks.end(), update.looks.begin(), update.looks.end());
    };
    for (const Ping& ping : pings) collect(pipeline.process(ping, navigation));
    collect(pipeline.finish());
    return looks;
}

void expectSame(const std::vector<TrackLook>& a, const std::vector<TrackLook>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].time, b[i].time);
        EXPECT_EQ(a[i].track, b[i].track);
        EXPECT_EQ(a[i].position_m, b[i].position_m);
        EXPECT_EQ(a[i].covariance_m2, b[i].covariance_m2);
    }
}

TEST(ScanningSonarPipeline, FollowsAnApproachingTargetWhereItIs) {
    const auto looks = run(scanOf(30, 5, -0.3, 600));
    ASSERT_GE(looks.size(), 8u);
    int confirmed = 0;
    for (const TrackLook& look : looks) {
        if (look.state != TrackState::Confirmed) continue;
        ++confirmed;
        const double t = secondsBetween(Timestamp{}, look.time);
        EXPECT_NEAR(look.position_m.x(), 30 - 0.3 * t, 0.5) << t;
        EXPECT_NEAR(look.position_m.y(), 5, 0.8) << t;
        EXPECT_EQ(look.track, looks.front().track);
    }
    EXPECT_GE(confirmed, 6);
}

TEST(ScanningSonarPipeline, FollowsATargetInThePictureOfAWholeSweepToo) {
    for (const DetectOn detect_on : {DetectOn::Sweep, DetectOn::EnhancedSweep}) {
        ScanningSonarPipeline::Params params;
        params.regions.picture.detect_on = detect_on;
        ScanningSonarPipeline pipeline(params, 1);
        const auto pings = scanOf(30, 5, -0.3, 600);
        int confirmed = 0;
        for (const Ping& ping : pings) {
            const Update& update = pipeline.process(ping, {});
            EXPECT_TRUE(update.regions.empty() || update.sweep_ended) << "regions come when a sweep is over";
            EXPECT_TRUE(std::is_sorted(update.regions.begin(), update.regions.end(),
                                       [](const Region& a, const Region& b) { return a.time < b.time; }));
            for (const TrackLook& look : update.looks) {
                if (look.state != TrackState::Confirmed) continue;
                ++confirmed;
                const double t = secondsBetween(Timestamp{}, look.time);
                EXPECT_LE(look.time, pipeline.settledUntil() + Microseconds(6'000'000));
                EXPECT_NEAR(look.position_m.x(), 30 - 0.3 * t, 0.5) << t;
                EXPECT_NEAR(look.position_m.y(), 5, 0.8) << t;
            }
        }
        EXPECT_GE(confirmed, 6);
    }
}

TEST(ScanningSonarPipeline, WithoutMotionCorrectionASweepIsDrawnFromWhereItBegan) {
    ScanningSonarPipeline::Params params;
    params.tracker.method.motion_correction = false;
    PoseHistory navigation;  // half a metre per second ahead
    for (int i = 0; i < 700; ++i)
        navigation.add({Timestamp(microsecondsFromSeconds(0.1 * i)), {0.05 * i, 0, Bearing::degrees(0)}});
    ScanningSonarPipeline pipeline(params, 1);
    std::set<double> places;
    for (const Ping& ping : scanOf(30, 5, 0, 300)) {
        const Update& update = pipeline.process(ping, navigation);
        EXPECT_EQ(update.pose.north_m, update.later_pose.north_m);
        places.insert(update.pose.north_m);
    }
    EXPECT_EQ(places.size(), 6U);  // sweeps of 50 pings
}

TEST(ScanningSonarPipeline, TargetNearTheTurnIsSeenOnTheWayOutAndOnTheWayBack) {
    // 5° from the end of the sector the beam comes by twice within 0.6 s, and sees the same pixels.
    const double angle = radiansFromDegrees(40);
    int seen = 0;
    for (const TrackLook& look : run(scanOf(30 * std::cos(angle), 30 * std::sin(angle), 0, 600))) {
        EXPECT_TRUE(look.seen) << secondsBetween(Timestamp{}, look.time);
        seen += look.seen;
    }
    EXPECT_EQ(seen, 12);  // twice in each of six turns
}

TEST(ScanningSonarPipeline, PaintingTheFanChangesNoTrack) {
    const auto pings = scanOf(30, 5, -0.3, 300);
    expectSame(run(pings), run(pings, {}, {}, false));
}

TEST(ScanningSonarPipeline, SameBitsOnAnyThread) {
    const auto pings = scanOf(30, 5, -0.3, 300);
    const auto here = run(pings);
    std::vector<TrackLook> there;
    std::jthread([&] { there = run(pings); }).join();
    expectSame(here, there);
}

TEST(ScanningSonarPipeline, VehicleMotionIsTakenOut) {
    // The vehicle turns by 20° in 30 s; the target stands still in the local frame, so its bearing swings back.
    PoseHistory navigation;
    for (int i = 0; i <= 400; ++i)
        navigation.add(
            {Timestamp(microsecondsFromSeconds(i * 0.1 - 1)), {0, 0, Bearing::degrees((i * 0.1 - 1) * 20 / 30)}});
    std::vector<Ping> pings = scanOf(25, 0, 0, 300);
    for (std::size_t i = 0; i < pings.size(); ++i) {
        // What the head sees of a target at 25 m due north while the bow is at `heading`.
        const double heading = static_cast<double>(i) * ping_s * 20 / 30;
        const double angle = radiansFromDegrees(-heading);
        pings[i].levels =
            scanOf(25 * std::cos(angle), 25 * std::sin(angle), 0, static_cast<int>(i % 100) + 1).back().levels;
    }
    for (const TrackLook& look : run(pings, {}, navigation)) {
        EXPECT_NEAR(look.position_m.x(), 25, 0.7);
        EXPECT_NEAR(look.position_m.y(), 0, 0.9);
    }
}

TEST(ScanningSonarPipeline, RangesAndBearingsAreFromWhereTheHeadWasAtTheLook) {
    // The vehicle goes north at 1 m/s past a target that stands still, 30 m ahead and 5 m to the east at first.
    PoseHistory navigation;
    for (int i = 0; i <= 400; ++i) navigation.add({Timestamp(microsecondsFromSeconds(i * 0.1)), {i * 0.1, 0, {}}});
    std::vector<Ping> pings = scanOf(30, 5, -1.0, 220);
    int seen = 0;
    for (const TrackLook& look : run(pings, {}, navigation)) {
        const Pose head = *navigation.at(look.time, 1.0);
        const double north = look.position_m.x() - head.north_m, east = look.position_m.y() - head.east_m;
        EXPECT_NEAR(look.range_m, std::hypot(north, east), 0.11) << look.seen;
        EXPECT_NEAR(look.bearing.inDegrees(), degreesFromRadians(std::atan2(east, north)), 0.5) << look.seen;
        seen += look.seen;
    }
    EXPECT_GE(seen, 3);
}

TEST(ScanningSonarPipeline, PingWithUnknownBearingIsDroppedAndCounted) {
    auto pings = scanOf(30, 5, 0, 60);
    pings[30].motor_lost_sync = true;
    ScanningSonarPipeline pipeline({}, 1);
    for (const Ping& ping : pings) pipeline.process(ping, {});
    EXPECT_EQ(pipeline.unsynchronisedPings(), 1u);
}

TEST(ScanningSonarPipeline, TakesPingsOfAnyShape) {
    ScanningSonarPipeline pipeline({}, 1);
    RandomStream random(3, 0, 0);
    for (int i = 0; i < 400; ++i) {
        Ping ping;
        ping.time = Timestamp(microsecondsFromSeconds(i * 0.1));
        ping.bearing = Bearing::degrees(360 * random.uniform());
        ping.step_rad = radiansFromDegrees(14.0 * random.uniform());
        ping.range_scale_m = random.uniform() < 0.1 ? 0.0 : 100 * random.uniform();
        ping.sound_speed_mps = 1500;
        ping.bin_interval_s = random.uniform() < 0.1 ? 0.0 : 1e-4 * random.uniform();
        ping.levels.resize(static_cast<std::size_t>(800 * random.uniform()));
        for (auto& level : ping.levels) level = static_cast<std::uint8_t>(random.bits());
        for (const TrackLook& look : pipeline.process(ping, {}).looks) {
            EXPECT_TRUE(look.position_m.allFinite());
            EXPECT_TRUE(look.covariance_m2.allFinite());
        }
    }
    pipeline.finish();
}

TEST(ScanningSonarPipeline, DesignatedTargetIsMarkedAndOnlyIt) {
    ScanningSonarPipeline pipeline({}, 1);
    pipeline.designate(30.5, Bearing::degrees(9));
    int marked = 0;
    for (const Ping& ping : scanOf(30, 5, 0, 300))
        for (const TrackLook& look : pipeline.process(ping, {}).looks) {
            marked += look.target;
            EXPECT_EQ(look.target, std::hypot(look.position_m.x() - 30, look.position_m.y() - 5) < 3);
        }
    EXPECT_GE(marked, 4);
}

TEST(ScanningSonarPipeline, EveryParameterHasAUniqueNameAHelpAndADefaultWithinItsLimits) {
    std::set<std::string> names;
    for (const ParameterInfo& info : describeParameters<ScanningSonarPipeline::Params>()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.help.empty()) << info.name;
        EXPECT_TRUE(info.checked(info.default_value)) << info.name;
    }
    for (const char* fixed : {"range_m", "sector_centre_deg", "sector_width_deg", "step_deg", "channel", "gain_percent",
                              "bits", "sound_speed", "mount_inverted", "particles"})
        EXPECT_TRUE(names.contains(fixed)) << fixed;
}

}  // namespace
}  // namespace echotrail
