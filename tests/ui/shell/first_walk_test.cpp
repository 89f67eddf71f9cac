#include "app/console/live_connection.hpp"
#include "core/recording/recording.hpp"
#include "qt_environment.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/panels/connection/connection_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/views/fan_geometry.hpp"
#include "ui/views/fan_view.hpp"
#include "ui/views/orientation.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTemporaryDir>
#include <QTest>

// The way of someone who has never seen the console: with keys, mouse and what stands on the screen alone.

namespace echotrail {
namespace {

using test::await;

class FirstWalk : public testing::Test {
protected:
    FirstWalk() {
        before_ = qgetenv("XDG_DATA_HOME");
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
        window_.alerts().setSound({});
    }
    ~FirstWalk() override { qputenv("XDG_DATA_HOME", before_); }

    FanView& fan() { return window_.fan(); }
    const Scene& scene() { return *window_.bridge().scene(); }
    const Track* target() {
        for (const Track& track : scene().tracks)
            if (track.target) return &track;
        return nullptr;
    }
    /// Where a place of the ground is on the fan, which nobody has zoomed or dragged.
    QPoint onScreen(const Eigen::Vector2d& place) {
        const FanGeometry geometry = fitted(scene().latest.pose, upOf(scene(), fan().orientation()),
                                            sectorToFit(scene()), fan().rect(), QMarginsF(44, 58, 44, 22));
        return geometry.toScreen(place.x(), place.y()).toPoint();
    }
    void click(const Eigen::Vector2d& place) {
        QTest::mouseMove(&fan(), onScreen(place));
        QTest::mouseClick(&fan(), Qt::LeftButton, {}, onScreen(place));
    }
    /// Follows the run until something is proven, then holds it still.
    void watchDemonstration() {
        window_.openDemonstration();
        ASSERT_TRUE(await([&] { return window_.bridge().timeline().pings() > 0; }));
        window_.bridge().setSpeed(64.0);
        window_.bridge().play();
        ASSERT_TRUE(await([&] {
            if (!window_.bridge().scene()) return false;
            return std::any_of(scene().tracks.begin(), scene().tracks.end(),
                               [](const Track& track) { return track.state == TrackState::Confirmed; });
        }));
        QTest::keyClick(&window_, Qt::Key_Space);
        ASSERT_TRUE(await([&] { return window_.bridge().status().state == ReplayState::Paused; }));
        window_.bridge().poll();
    }

    QByteArray before_;  ///< where data went before
    QTemporaryDir folder_;
    MainWindow window_{{.remember = false, .steady_alerts = true, .live = liveAccess()}};
};

TEST_F(FirstWalk, FromTheDemonstrationToATargetAMarkADistanceAParameterAndAnAlert) {
    watchDemonstration();
    const auto proven = std::find_if(scene().tracks.begin(), scene().tracks.end(),
                                     [](const Track& track) { return track.state == TrackState::Confirmed; });
    ASSERT_NE(proven, scene().tracks.end());
    const Eigen::Vector2d place = proven->estimate.mean.head<2>();

    click(place);
    ASSERT_TRUE(await([&] { return target() != nullptr; }));
    EXPECT_TRUE(window_.messages().text().contains("Delete"));

    QTest::mouseMove(&fan(), onScreen(place) + QPoint(60, 40));
    QTest::keyClick(&fan(), Qt::Key_M);
    ASSERT_EQ(window_.marks().rowCount(), 1);

    QTest::keyClick(&fan(), Qt::Key_F4);
    click(place);
    QTest::mouseClick(&fan(), Qt::LeftButton, {}, onScreen(place) + QPoint(120, 80));
    EXPECT_TRUE(fan().measures());
    QTest::keyClick(&fan(), Qt::Key_Escape);
    EXPECT_FALSE(fan().measures());

    QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
    QWidget* field = QApplication::focusWidget();
    QTest::keyClicks(field, "seed excess");
    QTest::keyClick(field, Qt::Key_Down);
    const double before = window_.bridge().params().regions.screen.seed_excess_db;
    QTest::keyClicks(QApplication::focusWidget(), "17");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_NE(before, 17.0);
    EXPECT_TRUE(await([&] { return window_.bridge().params().regions.screen.seed_excess_db == 17.0; }))
        << "what is typed replaces what was there";

    fan().setFocus();
    QTest::keyClick(&fan(), Qt::Key_G);
    for (const QPoint& corner : {QPoint(-90, -90), QPoint(90, -90), QPoint(90, 90), QPoint(-90, 90)})
        QTest::mouseClick(&fan(), Qt::LeftButton, {}, onScreen(place) + corner);
    QTest::keyClick(&fan(), Qt::Key_Return);
    ASSERT_EQ(window_.areas().rowCount(), 1);
    QTest::keyClick(&fan(), Qt::Key_Space);
    ASSERT_TRUE(await([&] { return window_.alerts().summary().new_alarm; }));
    QTest::keyClick(&fan(), Qt::Key_A);
    EXPECT_FALSE(window_.alerts().summary().new_alarm);
}

TEST_F(FirstWalk, ALiveRunIsRecordedAndSaysWhereSoThatItIsFoundAgain) {
    window_.connection().connectTo("simulation://demo", {}, true);
    ASSERT_TRUE(await([&] { return window_.bridge().liveState().run.pings > 20; }));
    window_.bridge().close();
    const QString folder = folder_.path() + "/echotrail/recordings/";
    ASSERT_TRUE(window_.messages().text().contains(folder)) << window_.messages().text().toStdString();
    const QString path = folder + QDir(folder).entryList(QDir::Files).value(0);
    EXPECT_TRUE(window_.messages().text().contains(path));
    const auto recording = openRecording(path.toStdString());
    ASSERT_TRUE(recording) << recording.error();
    EXPECT_GT((*recording)->info().pings, 20u);
}

}  // namespace
}  // namespace echotrail
