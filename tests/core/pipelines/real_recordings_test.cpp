#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/recording/recording.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace echotrail {
namespace {

const std::string shared = ECHOTRAIL_SHARED_DATA;

#define NEEDS_SHARED_DATA() \
    if (!std::filesystem::exists(shared)) GTEST_SKIP() << "needs the shared recordings"

struct Outcome {
    std::vector<TrackLook> looks;
    std::uint64_t confirmed = 0;
    Timestamp first{};
};

Outcome runOn(const std::vector<Ping>& pings) {
    ScanningSonarPipeline pipeline({}, 1);
    Outcome run;
    run.first = pings.front().time;
    const auto collect = [&](const Update& update) {
        run.looks.insert(run.looks.end(), update.looks.begin(), update.looks.end());
    };
    for (const Ping& ping : pings) collect(pipeline.process(ping, {}));
    collect(pipeline.finish());
    run.confirmed = pipeline.confirmedTracks();
    return run;
}

std::vector<Ping> pingsOf(const std::string& file) {
    auto source = openRecording(shared + "/seanet/" + file);
    EXPECT_TRUE(source) << source.error();
    std::vector<Ping> pings;
    while (auto ping = (*source)->next()) pings.push_back(std::move(*ping));
    return pings;
}

/// A Micron's scan lines, as its driver logged them: sequence, stamp, angle (deg), bin step (m), bins, levels as hex.
std::vector<Ping> micronPings(const std::string& file) {
    std::ifstream csv(shared + "/seanet/micron_dst_rosbag/" + file);
    std::vector<Ping> pings;
    std::string line;
    while (std::getline(csv, line)) {
        if (line.empty() || !std::isdigit(static_cast<unsigned char>(line[0]))) continue;
        std::stringstream fields(line);
        std::array<std::string, 6> field;
        for (std::string& text : field) std::getline(fields, text, ',');
        Ping ping;
        ping.sequence = pings.size();
        ping.time = Timestamp(microsecondsFromSeconds(std::stod(field[1])));
        ping.bearing = Bearing::degrees(std::stod(field[2]));
        const double bin_m = std::stod(field[3]);
        ping.sound_speed_mps = 1500;
        ping.bin_interval_s = 2 * bin_m / ping.sound_speed_mps;
        ping.frequency_hz = 700e3;
        ping.step_rad = radiansFromDegrees(bin_m > 0.07 ? 3.6 : 1.8);
        for (std::size_t i = 0; i + 1 < field[5].size(); i += 2)
            ping.levels.push_back(static_cast<std::uint8_t>(std::stoi(field[5].substr(i, 2), nullptr, 16)));
        ping.range_scale_m = bin_m * static_cast<double>(ping.levels.size());
        pings.push_back(std::move(ping));
    }
    return pings;
}

/// Confirmed tracks that moved: further than 1.5 m and than three deviations over their life.
int movingTracks(const Outcome& run) {
    std::map<int, std::pair<TrackLook, TrackLook>> ends;
    std::map<int, bool> confirmed;
    for (const TrackLook& look : run.looks) {
        ends.try_emplace(look.track, look, look).first->second.second = look;
        confirmed[look.track] |= look.state == TrackState::Confirmed;
    }
    int moving = 0;
    for (const auto& [id, pair] : ends) {
        const double moved = (pair.second.position_m - pair.first.position_m).norm();
        const double sigma = std::sqrt(pair.first.covariance_m2.trace() + pair.second.covariance_m2.trace());
        moving += confirmed[id] && moved > 1.5 && moved > 3 * sigma;
    }
    return moving;
}

struct TruthRow {
    double t, range_m, bearing_deg;
};

std::vector<TruthRow> truth() {
    std::ifstream csv(shared + "/scanning-sonar/seaking_target_first312.csv");
    std::string line;
    std::getline(csv, line);
    std::vector<TruthRow> rows;
    while (std::getline(csv, line)) {
        TruthRow row{};
        int sweep = 0, record = 0;
        if (std::sscanf(line.c_str(), "%d,%d,%lf,%lf,%lf", &sweep, &record, &row.t, &row.range_m, &row.bearing_deg) ==
            5)
            rows.push_back(row);
    }
    return rows;
}

TEST(SeaKingApproach, OneTrackFollowsTheTargetFromItsThirdSightToTheEnd) {
    NEEDS_SHARED_DATA();
    const Outcome run = runOn(pingsOf("seaking_dfs_v4log/seaking_dfs_first312.V4LOG"));
    EXPECT_EQ(run.confirmed, 1u);
    EXPECT_EQ(movingTracks(run), 1);
    const auto rows = truth();
    ASSERT_EQ(rows.size(), 11u);
    int followed = 0, used = 0;
    double range_error = 0, bearing_error = 0;
    std::map<int, int> ids;
    for (std::size_t i = 2; i < rows.size(); ++i) {
        for (const TrackLook& look : run.looks) {
            const double t = secondsBetween(run.first, look.time);
            if (look.state != TrackState::Confirmed || !look.seen || std::abs(t - rows[i].t) > 0.3) continue;
            ++ids[look.track];
            ++used;
            range_error += std::abs(look.range_m - rows[i].range_m);
            bearing_error += std::abs(look.bearing.inDegrees() - rows[i].bearing_deg);
            ++followed;
            break;
        }
    }
    EXPECT_GE(used, 8);
    EXPECT_EQ(ids.size(), 1u);
    EXPECT_LT(range_error / followed, 0.3);
    EXPECT_LT(bearing_error / followed, 3.0);
}

TEST(StandingHead, AnotherSoundersStreaksGiveNoMovingTrack) {
    NEEDS_SHARED_DATA();
    EXPECT_EQ(movingTracks(runOn(pingsOf("seaking_dst_udp/sonar_stream_part1.bin"))), 0);
}

TEST(MicronBottom, SlopesAndBottomGiveNoMovingTrack) {
    NEEDS_SHARED_DATA();
    for (const char* file : {"2014-07-18-20-59-31.csv", "2014-07-18-21-11-13.csv"}) {
        const auto pings = micronPings(file);
        ASSERT_GT(pings.size(), 1000u);
        const Outcome run = runOn(pings);
        EXPECT_EQ(movingTracks(run), 0) << file;
        EXPECT_LE(run.confirmed, 2u) << file;
    }
}

}  // namespace
}  // namespace echotrail
