#include "ui/panels/alerts/alerts_panel.hpp"

#include "tests/ui/look/sample_scene.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/panels/alerts/alert_delegate.hpp"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QListView>
#include <QTemporaryDir>
#include <QTest>

namespace echotrail {
namespace {

/// Its target lost.
Scene lostScene() {
    Scene scene = test::fullScene();
    scene.tracks[0].state = TrackState::Lost;
    return scene;
}

LiveState brokenLink() {
    LiveState state;
    state.sonar = {false, "connection refused", 10.0};
    return state;
}

class AlertsPanelTest : public testing::Test {
protected:
    AlertsPanelTest() {
        centre_.setSound([this] { ++sounds_; });
        panel_.resize(380, 300);
        panel_.show();
    }
    QString role(int row, int role) { return centre_.model().index(row).data(role).toString(); }

    AlertCentre centre_;
    QAbstractItemModelTester tester_{&centre_.model(), QAbstractItemModelTester::FailureReportingMode::Fatal};
    AlertsPanel panel_{centre_};
    int sounds_ = 0;
};

TEST_F(AlertsPanelTest, AClickOnItsButtonAcknowledges) {
    centre_.showScene(lostScene(), true);
    ASSERT_EQ(centre_.model().rowCount(), 1);
    EXPECT_TRUE(centre_.summary().new_alarm);
    QListView& list = panel_.list();
    const QRect row = list.visualRect(centre_.model().index(0));
    const auto& delegate = static_cast<const AlertDelegate&>(*list.itemDelegate());
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(60, 5));
    EXPECT_TRUE(centre_.summary().new_alarm) << "a click beside it only selects";
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, delegate.buttonRect(row, list.font()).center());
    EXPECT_FALSE(centre_.summary().new_alarm);
    EXPECT_EQ(centre_.summary().alarms, 1) << "it lasts";
}

TEST_F(AlertsPanelTest, ALiveAlarmSoundsAndARecordingsDoesNot) {
    centre_.showScene(lostScene(), false);
    EXPECT_TRUE(centre_.summary().new_alarm);
    EXPECT_EQ(sounds_, 0);
    centre_.showNothing();
    EXPECT_EQ(centre_.model().rowCount(), 0);
    centre_.showScene(lostScene(), true);
    EXPECT_EQ(sounds_, 1);
}

TEST_F(AlertsPanelTest, WindingBackForgetsWhatHasNotHappenedYet) {
    Scene scene = lostScene();
    centre_.showScene(scene, false);
    scene = test::fullScene();
    scene.latest.time -= std::chrono::seconds(10);
    centre_.showScene(scene, false);
    EXPECT_EQ(centre_.model().rowCount(), 0);
}

TEST_F(AlertsPanelTest, AGuardZoneIsToldOfAndEndsWithItsAcknowledgement) {
    centre_.showScene(test::fullScene(), false);
    centre_.guardZoneEntered(2, "North");
    EXPECT_EQ(role(0, Qt::DisplayRole), "T02 in guard zone North");
    EXPECT_TRUE(centre_.summary().new_alarm);
    centre_.acknowledgeMostUrgent();
    EXPECT_EQ(centre_.summary().alarms, 0);
    EXPECT_TRUE(centre_.model().index(0).data(AlertModel::OverRole).toBool());
}

TEST_F(AlertsPanelTest, AMutedTrackRaisesNothing) {
    centre_.showScene(lostScene(), true);
    centre_.setMuted(1, true);
    EXPECT_FALSE(centre_.summary().new_alarm);
    EXPECT_EQ(centre_.summary().alarms, 0);
    centre_.guardZoneEntered(1, "North");
    EXPECT_EQ(centre_.summary().alarms, 0);
    centre_.setMuted(1, false);
    centre_.showScene(lostScene(), true);
    EXPECT_TRUE(centre_.summary().new_alarm) << "it is still lost";
}

TEST_F(AlertsPanelTest, RowsMoveWithoutAReset) {
    int resets = 0;
    QObject::connect(&centre_.model(), &QAbstractItemModel::modelReset, [&] { ++resets; });
    centre_.guardZoneEntered(2, "North");
    centre_.guardZoneEntered(4, "South");
    const QPersistentModelIndex kept = centre_.model().index(1);
    const QString title = kept.data().toString();
    centre_.acknowledge(centre_.model().idAt(0));
    EXPECT_EQ(kept.row(), 0);
    EXPECT_EQ(kept.data().toString(), title);
    EXPECT_EQ(resets, 0);
}

TEST_F(AlertsPanelTest, ShortTroubleWithALinkIsNone) {
    centre_.showLive(brokenLink(), 5.0);
    EXPECT_EQ(centre_.model().rowCount(), 0);
    EXPECT_EQ(sounds_, 0);
}

TEST_F(AlertsPanelTest, OnlyLiveAlertsAreLogged) {
    const QTemporaryDir folder;
    centre_.setLog(folder.filePath("alerts.log"));
    centre_.showScene(lostScene(), false);
    EXPECT_FALSE(QFile::exists(folder.filePath("alerts.log")));
    centre_.showNothing();
    centre_.showScene(lostScene(), true);
    EXPECT_TRUE(QFile::exists(folder.filePath("alerts.log")));
    QString said;
    QObject::connect(&centre_, &AlertCentre::noticed, [&](const QString& text, bool) { said = text; });
    centre_.setLog("/proc/no/alerts.log");
    centre_.guardZoneEntered(2, "North");
    EXPECT_TRUE(said.contains("/proc/no/alerts.log"));
}

TEST_F(AlertsPanelTest, SteadyAlertsAreAlwaysLit) {
    centre_.setSteady(true);
    centre_.showScene(lostScene(), true);
    int flashes = 0;
    QObject::connect(&centre_, &AlertCentre::flashed, [&] { ++flashes; });
    QTest::qWait(600);
    EXPECT_EQ(flashes, 0);
    EXPECT_TRUE(centre_.isLit(AlertPriority::Alarm));
    centre_.setSteady(false);
    flashes = 0;
    QTest::qWait(600);
    EXPECT_GE(flashes, 1);
}

}  // namespace
}  // namespace echotrail
