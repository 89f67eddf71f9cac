#include "ui/alerts/alert_rules.hpp"

#include "tests/ui/look/sample_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace echotrail {
namespace {

constexpr double longest_gap_s = 5.0;

/// A head that scans, with heading and recording, all well.
LiveState soundState() {
    LiveState state;
    state.sonar = {true, {}, 0.1};
    state.navigation = LiveLink{true, {}, 0.1};
    state.heading_age_s = 0.2;
    state.run.recorder.recording = true;
    state.run.recorder.free_bytes = 500'000'000'000;
    return state;
}

const Situation* find(const std::vector<Situation>& situations, const QString& key) {
    const auto found = std::find_if(situations.begin(), situations.end(), [&](const auto& s) { return s.key == key; });
    return found == situations.end() ? nullptr : &*found;
}

TEST(AlertRules, NothingIsToldWhileAllIsWell) {
    EXPECT_TRUE(AlertRules::ofLive(soundState(), longest_gap_s).empty());
    EXPECT_TRUE(AlertRules::ofScene(test::bareScene(), true).empty());
}

TEST(AlertRules, ALinkIsBrokenOrQuiet) {
    LiveState state = soundState();
    state.sonar.age_s = 2.5;
    auto told = AlertRules::ofLive(state, longest_gap_s);
    ASSERT_NE(find(told, "sonar_link"), nullptr);
    EXPECT_EQ(find(told, "sonar_link")->priority, AlertPriority::Warning);
    EXPECT_EQ(find(told, "sonar_link")->title, "Sonar is quiet");
    state.sonar = {false, "connection refused", {}};
    told = AlertRules::ofLive(state, longest_gap_s);
    EXPECT_EQ(find(told, "sonar_link")->title, "Link to the sonar lost");
    EXPECT_EQ(find(told, "sonar_link")->cause, "connection refused · never heard");
}

TEST(AlertRules, OfATrackerThatIsNotHeardOnlyItsLinkIsTold) {
    LiveState state = soundState();
    state.tracker = TrackerState{};
    state.heading_age_s.reset();
    const auto told = AlertRules::ofLive(state, longest_gap_s);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].key, "tracker_link");
}

TEST(AlertRules, ALateReportOfATrackerIsOneSituationNotOneOfAllItTellsOf) {
    LiveState state = soundState();
    state.tracker.emplace();
    state.tracker->link = {true, {}, 0.1};  // pictures arrive
    state.tracker->report_age_s = 6.0;
    state.sonar.age_s = state.heading_age_s = 6.1;
    const auto told = AlertRules::ofLive(state, longest_gap_s);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].title, "Tracker is quiet");
    state.tracker->report_age_s = 0.5;
    EXPECT_EQ(AlertRules::ofLive(state, longest_gap_s).size(), 2U) << "now it says that both are old";
}

TEST(AlertRules, AHeadingIsMissedOnlyWhereOneWasAskedFor) {
    LiveState state = soundState();
    state.heading_age_s.reset();
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "heading")->title, "No heading");
    state.heading_age_s = 5.1;
    EXPECT_NE(find(AlertRules::ofLive(state, longest_gap_s), "heading"), nullptr);
    state.navigation.reset();
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "heading"), nullptr);
}

TEST(AlertRules, TroubleWithRecordingIsAnAlarmAndLittleRoomACaution) {
    LiveState state = soundState();
    state.run.recorder.disk = DiskState::Low;
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "disk")->priority, AlertPriority::Caution);
    state.run.recorder.disk = DiskState::Full;
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "disk")->priority, AlertPriority::Alarm);
    state.run.recorder.error = "no space left";
    const auto told = AlertRules::ofLive(state, longest_gap_s);
    EXPECT_EQ(find(told, "recording")->priority, AlertPriority::Alarm);
    EXPECT_EQ(find(told, "disk"), nullptr) << "one situation, one alert";
}

TEST(AlertRules, RoomIsCountedInMinutesAtThePresentRate) {
    LiveState state = soundState();
    state.run.first_ping = test::scene_time;
    state.run.last_ping = test::scene_time + std::chrono::minutes(10);
    state.run.recorder.bytes = 1'000'000'000;
    state.run.recorder.free_bytes = 5'900'000'000;
    EXPECT_NEAR(*minutesLeft(state.run), 59.0, 1e-9);
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "disk")->priority, AlertPriority::Caution);
    state.run.recorder.free_bytes = 400'000'000;
    EXPECT_EQ(find(AlertRules::ofLive(state, longest_gap_s), "disk")->priority, AlertPriority::Alarm);
    state.run.last_ping = test::scene_time + std::chrono::seconds(10);
    EXPECT_FALSE(minutesLeft(state.run)) << "too early to tell";
}

TEST(AlertRules, OnlyTheOperatorsTargetIsMissed) {
    Scene scene = test::fullScene();
    EXPECT_TRUE(AlertRules::ofScene(scene, true).empty()) << "T03 is lost, but nobody's";
    scene.tracks[0].state = TrackState::Lost;
    const auto told = AlertRules::ofScene(scene, true);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].priority, AlertPriority::Alarm);
    EXPECT_EQ(told[0].title, "T01 lost, no echo for 1.7 s");
}

TEST(AlertRules, ATrackThatHasANameIsCalledByIt) {
    Scene scene = test::fullScene();
    scene.tracks[0].state = TrackState::Lost;
    const TrackNames names{{1, "buoy"}};
    EXPECT_TRUE(AlertRules::ofScene(scene, true, names).front().title.startsWith("T01 buoy lost"));
    EXPECT_EQ(AlertRules::guardZoneEntered(1, "pier", names).title, "T01 buoy in guard zone pier");
    EXPECT_EQ(AlertRules::guardZoneEntered(2, "pier", names).title, "T02 in guard zone pier");
}

TEST(AlertRules, ARecordingsMissingHeadingIsToldToo) {
    Scene scene = test::bareScene();
    scene.navigation_known = true;
    scene.latest.navigation_gap = true;
    EXPECT_NE(find(AlertRules::ofScene(scene, false), "heading"), nullptr);
    EXPECT_EQ(find(AlertRules::ofScene(scene, true), "heading"), nullptr) << "the links tell it then";
}

}  // namespace
}  // namespace echotrail
