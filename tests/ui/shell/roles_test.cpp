#include "qt_environment.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/message_strip.hpp"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QFile>
#include <QMenuBar>
#include <QSettings>
#include <QTabBar>
#include <QTest>

namespace echotrail {
namespace {

QDockWidget* dock(MainWindow& window, const char* name) { return window.findChild<QDockWidget*>(name); }

TEST(Roles, EachKeepsItsDocksAsTheyWereLeftAlsoToTheNextStart) {
    QSettings().clear();
    {
        MainWindow window({.remember = true, .play_on_open = false});
        window.resize(1600, 1000);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        EXPECT_EQ(window.role(), Role::Operate);
        dock(window, "alerts")->close();
        QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
        EXPECT_EQ(window.role(), Role::Tune);
        EXPECT_TRUE(dock(window, "alerts")->isVisibleTo(&window)) << "it was closed in another role";
        EXPECT_FALSE(dock(window, "parameters")->visibleRegion().isEmpty());
        EXPECT_FALSE(dock(window, "tracks")->visibleRegion().isEmpty()) << "both at once";
        dock(window, "time_line")->close();
        QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
        EXPECT_FALSE(dock(window, "alerts")->isVisibleTo(&window));
        EXPECT_TRUE(dock(window, "time_line")->isVisibleTo(&window));
        QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
        EXPECT_FALSE(dock(window, "time_line")->isVisibleTo(&window));
        window.close();
    }
    MainWindow window({.remember = true, .play_on_open = false});
    window.resize(1600, 1000);
    window.show();
    EXPECT_EQ(window.role(), Role::Tune);
    EXPECT_FALSE(dock(window, "time_line")->isVisibleTo(&window));
    window.setRole(Role::Operate);
    EXPECT_FALSE(dock(window, "alerts")->isVisibleTo(&window));
    QSettings().clear();
}

TEST(Roles, TheTabsOfTheMenuBarSwitchThem) {
    MainWindow window({.remember = false, .play_on_open = false});
    window.show();
    auto* tabs = window.menuBar()->findChild<QTabBar*>();
    ASSERT_NE(tabs, nullptr);
    tabs->setCurrentIndex(1);
    EXPECT_EQ(window.role(), Role::Review);
    window.setRole(Role::Operate);
    EXPECT_EQ(tabs->currentIndex(), 0);
}

TEST(SettingsFile, ADamagedOneIsSetAsideAndSaid) {
    QSettings().clear();
    QString path;
    {
        QSettings settings;
        settings.setValue("palette", "night");
        settings.sync();
        path = settings.fileName();
    }
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(600, '\0'));  // as after a loss of power
    file.close();
    MainWindow window({.remember = true, .play_on_open = false});
    EXPECT_TRUE(window.messages().text().contains(path + ".damaged")) << window.messages().text().toStdString();
    EXPECT_TRUE(QFile::exists(path + ".damaged"));
    EXPECT_NE(QSettings().value("palette").toString(), "night");
    QFile::remove(path + ".damaged");
    QSettings().clear();
}

}  // namespace
}  // namespace echotrail
