#include "app/console/live_connection.hpp"
#include "qt_environment.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/status_chip.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QTest>

namespace echotrail {
namespace {

using test::await;

class AlertsInTheWindow : public testing::Test {
protected:
    AlertsInTheWindow() {
        window_.alerts().setSound({});
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    StatusChip* chip() {
        for (auto* each : window_.findChildren<StatusChip*>())
            if (each->accessibleName().startsWith("ALERTS ")) return each;
        return nullptr;
    }

    MainWindow window_{{.remember = false, .steady_alerts = true, .live = liveAccess()}};
};

TEST_F(AlertsInTheWindow, AGuardZoneEnteredIsToldInTheBarAndAcknowledgedByAKey) {
    window_.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window_.bridge().isOpen(); }));
    EXPECT_EQ(chip()->value(), "none");
    window_.alerts().guardZoneEntered(3, "North");
    EXPECT_EQ(chip()->value(), "1 alarm");
    EXPECT_TRUE(chip()->toolTip().contains("T03 in guard zone North"));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    QTest::keyClick(&window_, Qt::Key_A);
    EXPECT_EQ(chip()->value(), "none");
}

TEST_F(AlertsInTheWindow, TheChipBringsTheListToTheFront) {
    auto* dock = window_.findChild<QDockWidget*>("alerts");
    ASSERT_NE(dock, nullptr);
    dock->close();
    chip()->click();
    EXPECT_TRUE(dock->isVisible());
}

TEST_F(AlertsInTheWindow, AHeadThatIsNotThereIsAWarningUntilItIsDisconnected) {
    window_.bridge().openLive("tcp://127.0.0.1:1", {}, false);
    ASSERT_TRUE(await([&] { return chip()->value() == "1 warning"; }));
    window_.bridge().close();
    EXPECT_EQ(chip()->value(), "none");
}

}  // namespace
}  // namespace echotrail
