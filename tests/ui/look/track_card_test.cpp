#include "sample_scene.hpp"
#include "ui/models/track_samples.hpp"
#include "ui/panels/tracks/strip_chart.hpp"
#include "ui/panels/tracks/target_card.hpp"
#include "ui/panels/tracks/term_bar.hpp"
#include "ui/panels/tracks/track_reasons.hpp"
#include "ui/panels/tracks/track_strips.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/style/formatter.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QTableView>
#include <QTest>

namespace echotrail {
namespace {

TEST(TrackSamples, TakeEachLookOnceAndForgetWhatIsGone) {
    TrackSamples samples;
    Scene scene = test::fullScene();
    scene.tracks[0].nis = 2.0;
    samples.add(scene);
    samples.add(scene);
    ASSERT_EQ(samples.of(1).size(), 1U);
    EXPECT_EQ(samples.of(1)[0].nis, 2.0);
    EXPECT_NEAR(samples.of(1)[0].effective, 0.592, 1e-9);
    scene.latest.time += std::chrono::seconds(3);
    scene.tracks[0].last_seen += std::chrono::seconds(3);
    scene.tracks[0].nis = 7.0;
    samples.add(scene);
    ASSERT_EQ(samples.of(1).size(), 2U);
    EXPECT_EQ(samples.of(1)[1].nis, 7.0);
    scene.tracks.erase(scene.tracks.begin());
    samples.add(scene);
    EXPECT_TRUE(samples.of(1).empty());
    EXPECT_FALSE(samples.of(2).empty());
}

TEST(TrackSamples, BeginAnewAfterAJumpBackAndKeepToALimit) {
    TrackSamples samples;
    Scene scene = test::fullScene();
    for (int i = 0; i < 300; ++i) {
        samples.add(scene);
        scene.latest.time += std::chrono::seconds(3);
        scene.tracks[0].last_seen += std::chrono::seconds(3);
    }
    EXPECT_EQ(samples.of(1).size(), TrackSamples::most_samples);
    scene = test::fullScene();
    samples.add(scene);
    EXPECT_EQ(samples.of(1).size(), 1U);
}

TEST(TrackSamples, TheFirstEchoOfATrackHadNothingToBeComparedWith) {
    TrackSamples samples;
    Scene scene = test::fullScene();
    scene.tracks[0].looks = 1;
    samples.add(scene);
    EXPECT_TRUE(samples.of(1).empty());
}

TEST(MissedShares, CountLooksWithoutAnEchoUpToEach) {
    std::vector<TrackLook> history(4);
    history[0].seen = history[1].seen = history[3].seen = true;
    const std::vector<double> shares = missedShares(history);
    ASSERT_EQ(shares.size(), 4U);
    EXPECT_EQ(shares[1], 0.0);
    EXPECT_NEAR(shares[2], 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(shares[3], 0.25, 1e-12);
}

TEST(TrackStrips, HaveTheLimitsDrawnAndTheBearingUnwrapped) {
    Track track = test::sampleTrack(1, TrackState::Confirmed, 12.0, 2.0);
    for (TrackLook& look : track.history) look.bearing = Bearing::degrees(look.seen ? 178.0 : -178.0);
    const std::vector<TrackSample> samples{{test::scene_time, 0.86, 7.5, 0.5}};
    const auto strips = TrackStrips::of(track, samples);
    ASSERT_EQ(strips.size(), 5U);
    EXPECT_EQ(strips[0].points.size(), track.history.size());
    EXPECT_NEAR(strips[1].points[4].value, 182.0, 1e-6) << "across the stern by 4°, not by 356";
    EXPECT_EQ(strips[2].value, "0.86");
    EXPECT_EQ(strips[3].limit, TrackStrips::nis_limit);
    EXPECT_EQ(strips[4].limit, TrackStrips::most_missed);
    EXPECT_EQ(strips[4].value, "14 %") << "one look of seven was missed";
}

TEST(StripChart, TheNewerIsToTheRightAndTheLargerHigherUp) {
    StripChart chart;
    chart.resize(380, 120);
    Strip strip{"Range m", "12"};
    strip.points = {{test::scene_time - std::chrono::seconds(30), 10.0}, {test::scene_time, 20.0}};
    chart.setStrips({strip}, test::scene_time, 60.0);
    const QPointF older = chart.placeOf(0, strip.points[0]);
    const QPointF newer = chart.placeOf(0, strip.points[1]);
    EXPECT_LT(older.x(), newer.x());
    EXPECT_GT(older.y(), newer.y());
    EXPECT_TRUE(chart.accessibleDescription().contains("Range m 12"));
    EXPECT_EQ(chartSpan(61.0), 120.0);
    EXPECT_EQ(chartSpan(4000.0), 7200.0);
}

TEST(TrackReasons, SayWhatHoldsOrEndsAState) {
    LifeParams params;
    params.confirm_existence = 0.9;
    const Timestamp now = test::scene_time;
    Track track = test::sampleTrack(1, TrackState::Tentative, 12.0, 2.0);
    track.looks = 2;
    EXPECT_EQ(TrackReasons::ofState(track, now, params), "2 of 3 echoes, existence 0.94 of 0.90");
    track.state = TrackState::Coasting;
    track.misses = 2;
    EXPECT_EQ(TrackReasons::ofState(track, now, params), "2 of 4 looks without an echo");
    track.state = TrackState::Lost;
    track.misses = 4;
    EXPECT_EQ(TrackReasons::ofState(track, now, params), "lost: 4 looks without an echo, limit 4");
    track.misses = 1;
    track.existence = 0.03;
    EXPECT_EQ(TrackReasons::ofState(track, now, params), "lost: existence 0.03 below 0.05");
    track.existence = 0.5;
    EXPECT_TRUE(TrackReasons::ofState(track, now + std::chrono::seconds(40), params).startsWith("lost: no echo for"));
}

TEST(TrackReasons, SayWhyTheLastLooksUsedNoEcho) {
    Track track = test::sampleTrack(1, TrackState::Coasting, 12.0, 2.0);
    const auto look = [](bool seen, NoEcho cause) {
        TrackLook one;
        one.seen = seen;
        one.no_echo = cause;
        return one;
    };
    const TrackLook seen = look(true, NoEcho::None), weak = look(false, NoEcho::UnderThreshold),
                    merged = look(false, NoEcho::Merged), silent = look(false, NoEcho::None);
    track.misses = 2;
    track.history = {seen, weak, merged, seen, weak};
    EXPECT_EQ(TrackReasons::ofLastLooks(track), "3 of 5 without an echo: 2 under the threshold, 1 merged with clutter");
    EXPECT_EQ(TrackReasons::ofState(track, test::scene_time, {}),
              QString::fromUtf8("2 of 4 looks without an echo · nothing stood out"));
    track.state = TrackState::Lost;
    track.misses = 4;
    track.history.back() = look(false, NoEcho::OutsideSector);
    EXPECT_TRUE(TrackReasons::ofState(track, test::scene_time, {}).endsWith("the sector leaves it out"));
    EXPECT_TRUE(TrackReasons::ofLastLooks(track).startsWith("until lost, 3 of 5 without an echo: "));
    track.state = TrackState::Confirmed;

    track.history.assign(TrackReasons::last_looks, seen);
    track.history.front() = merged;
    EXPECT_EQ(TrackReasons::ofLastLooks(track), "1 of 10 without an echo: merged with clutter");
    track.history.push_back(seen);
    EXPECT_EQ(TrackReasons::ofLastLooks(track), "10 of 10 with an echo") << "older ones do not count";
    track.history = {seen, silent};
    EXPECT_EQ(TrackReasons::ofLastLooks(track), "1 of 2 without an echo") << "a tracker that does not tell why";
    track.history.clear();
    EXPECT_EQ(TrackReasons::ofLastLooks(track), Formatter::unknown());
}

TEST(TrackReasons, HaveAWordForEveryCause) {
    Track track = test::sampleTrack(1, TrackState::Coasting, 12.0, 2.0);
    QSet<QString> states, looks;
    for (int cause = 1; cause < no_echo_causes; ++cause) {
        track.history.back().seen = false;
        track.history.back().no_echo = static_cast<NoEcho>(cause);
        states << TrackReasons::ofState(track, test::scene_time, {});
        looks << TrackReasons::ofLastLooks(track);
    }
    EXPECT_EQ(states.size(), no_echo_causes - 1);
    EXPECT_EQ(looks.size(), no_echo_causes - 1);
}

TEST(TrackReasons, NameTheRivalsTheLikestFirst) {
    Track track = test::sampleTrack(1, TrackState::Confirmed, 12.0, 2.0);
    track.expected_features = {1.0, -1.4, 0.8, 1.5, 20.0, 50.0};
    Region alike = test::sampleRegion(7, 12.3, 2.0, false);
    alike.features = track.expected_features;
    Region strange = test::sampleRegion(8, 12.1, 2.0, false);
    strange.features = {4.0, -0.9, 0.8, 1.5, 20.0, 50.0};
    Region dropped = test::sampleRegion(9, 12.0, 2.0, true);
    dropped.features = track.expected_features;
    Region far = test::sampleRegion(10, 19.0, 2.0, false);
    const auto rivals = rivalsOf(track, {strange, alike, dropped, far}, 3.0, LikenessParams{});
    ASSERT_EQ(rivals.size(), 2U);
    EXPECT_EQ(rivals[0].id, 7U);
    EXPECT_NEAR(rivals[0].likeness, 1.0, 1e-12);
    EXPECT_NEAR(rivals[0].distance_m, 0.3, 1e-12);
}

TEST(TargetCard, ShowsEachTermOfTheLikelihood) {
    TargetCard card;
    Scene scene = test::fullScene();
    Track& track = scene.tracks[0];
    track.expected_features = {1.0, -1.4, 0.8, 1.5, 20.0, 50.0};
    track.seen_features = {1.0, -0.8, 0.8, 1.5, 20.0, 50.0};
    track.nis = 5.0;
    Tracker::Params params;
    params.likeness.moment_sigma = 0.2;
    card.showTrack(track, scene, {}, params);
    const auto bars = card.findChildren<TermBar*>();
    ASSERT_EQ(bars.size(), 5);
    EXPECT_NEAR(bars[0]->term(), -2.5, 1e-9) << "place";
    EXPECT_NEAR(bars[1]->term(), 0.0, 1e-9) << "area";
    EXPECT_NEAR(bars[2]->term(), -4.5, 1e-9) << "moment";
    card.showNothing();
    EXPECT_TRUE(std::isnan(bars[0]->term()));
}

class TracksPanelTest : public testing::Test {
protected:
    TracksPanelTest() {
        panel_.resize(420, 900);
        panel_.show();
        panel_.setScene(scene_);
    }
    QString stateOf(int id) {
        return panel_.model().index(panel_.model().rowOf(id), TrackModel::State).data().toString();
    }

    Scene scene_ = test::fullScene();
    TracksPanel panel_;
};

TEST_F(TracksPanelTest, ATracksNameIsTakenByEnterAndForgottenWithTheRun) {
    panel_.editName();
    auto* field = panel_.findChild<QLineEdit*>();
    QTest::keyClicks(field, "  buoy  ");
    EXPECT_EQ(stateOf(1), "confirmed") << "not before Enter";
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(stateOf(1), QString::fromUtf8("buoy · confirmed"));
    const auto* title = panel_.findChild<TargetCard*>()->findChild<QLabel*>("title");
    panel_.setScene(scene_);
    EXPECT_EQ(title->text(), "T01 buoy");
    panel_.selectTrack(2);
    panel_.setScene(scene_);
    EXPECT_EQ(field->text(), "") << "the other has none";
    panel_.startAnew();
    panel_.setScene(scene_);
    EXPECT_EQ(stateOf(1), "confirmed");
}

TEST_F(TracksPanelTest, MutingIsAskedForAndShown) {
    std::vector<std::pair<int, bool>> asked;
    QObject::connect(&panel_, &TracksPanel::muteRequested, [&](int id, bool on) { asked.emplace_back(id, on); });
    panel_.toggleMute();
    EXPECT_EQ(stateOf(1), QString::fromUtf8("confirmed · muted"));
    panel_.toggleMute();
    EXPECT_EQ(stateOf(1), "confirmed");
    EXPECT_EQ(asked, (std::vector<std::pair<int, bool>>{{1, true}, {1, false}}));
}

TEST_F(TracksPanelTest, TheCourseIsTrueOnlyWithAHeading) {
    const TrackModel& model = panel_.model();
    const auto title = [&] { return model.headerData(TrackModel::Course, Qt::Horizontal).toString(); };
    EXPECT_EQ(title(), QString::fromUtf8("Crs °R"));
    EXPECT_EQ(model.index(0, TrackModel::Course).data().toString(), "326.3");
    scene_.navigation_known = true;
    scene_.latest.pose.heading = Bearing::degrees(20.0);
    panel_.setScene(scene_);
    EXPECT_EQ(title(), QString::fromUtf8("Crs °T"));
    EXPECT_EQ(model.index(0, TrackModel::Course).data().toString(), "326.3");
    scene_.tracks[0].estimate.mean.tail<2>().setZero();
    panel_.setScene(scene_);
    EXPECT_EQ(model.index(0, TrackModel::Course).data().toString(), QString::fromUtf8("—"));
}

}  // namespace
}  // namespace echotrail
