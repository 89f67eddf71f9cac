#include "ui/main_window/main_window.hpp"

#include "qt_environment.hpp"
#include "tests/ui/look/colour_measures.hpp"
#include "tests/ui/look/sample_scene.hpp"
#include "ui/chart/area_model.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/main_window/message_strip.hpp"
#include "ui/main_window/shortcuts_overlay.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/panels/beam/beam_panel.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <gtest/gtest.h>

#include <QDropEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

namespace echotrail {
namespace {

using test::await;

/// Perceived brightness of the brightest pixel, 0…255.
int brightest(const QImage& picture) {
    int most = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) most = std::max(most, qGray(picture.pixel(x, y)));
    return most;
}

class MainWindowTest : public testing::TestWithParam<Theme> {
protected:
    MainWindowTest() {
        window_.resize(1600, 1000);
        window_.setTheme(GetParam());
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    void openScan(std::uint64_t pings) {
        window_.bridge().open("scan", test::scanOpener(pings));
        ASSERT_TRUE(await([&] { return window_.bridge().isOpen(); }));
    }

    MainWindow window_{MainWindow::Options{.remember = false}};
};

TEST_P(MainWindowTest, OpensARecordingPlaysItAndStaysUsable) {
    openScan(200);
    ASSERT_TRUE(await([&] { return window_.bridge().status().position > 2; })) << "it plays by itself";
    QTest::keyClick(&window_, Qt::Key_Space);
    ASSERT_TRUE(await([&] { return window_.bridge().status().state == ReplayState::Paused; }));
    QTest::keyClick(&window_, Qt::Key_End);
    ASSERT_TRUE(await([&] { return window_.bridge().status().state == ReplayState::Ended; }));
    QTest::keyClick(&window_, Qt::Key_Left, Qt::ControlModifier);
    ASSERT_TRUE(await([&] { return window_.bridge().scene()->position == 199; }));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_P(MainWindowTest, NoWidgetIsWhiteAtNightAndNothingIsLeftUnthemed) {
    openScan(60);
    window_.bridge().pause();
    window_.bridge().seekPosition(50);
    ASSERT_TRUE(await([&] { return window_.bridge().scene() && window_.bridge().scene()->position == 50; }));
    const QImage picture = window_.grab().toImage();
    const bool night = GetParam() == Theme::Night;
    const bool day = GetParam() == Theme::Day;
    EXPECT_LT(brightest(picture), night ? 190 : 256);
    EXPECT_GT(brightest(picture), day ? 230 : 0);
    const auto& children = window_.findChildren<QWidget*>();
    for (const QWidget* widget : children) {
        if (!widget->isVisible() || widget->width() < 4 || widget->height() < 4) continue;
        const int background = qGray(widget->palette().color(QPalette::Window).rgb());
        EXPECT_TRUE(day ? background > 160 : background < 64)
            << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    }
}

TEST_P(MainWindowTest, AFileThatIsNoRecordingIsSaidInTheStripWithoutABox) {
    window_.openRecording("/no/such/file.V4LOG");
    ASSERT_TRUE(await([&] { return window_.messages().text().contains("not opened"); }));
    EXPECT_TRUE(window_.messages().isVisible());
    EXPECT_TRUE(window_.messages().text().contains("Ctrl+O")) << "it says what to do next";
    EXPECT_EQ(window_.findChild<QMessageBox*>(), nullptr);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_P(MainWindowTest, TheBarOfAReplayCanBeRead) {
    openScan(60);
    auto* chip = window_.findChild<StatusChip*>();
    ASSERT_NE(chip, nullptr);
    ASSERT_TRUE(await([&] { return chip->x() > 0; })) << "room for the word REPLAY";
    const QColor ground = window_.grab().toImage().pixelColor(chip->mapTo(&window_, QPoint(chip->width() - 4, 3)));
    EXPECT_GE(test::contrast(currentPalette().text, ground), GetParam() == Theme::Night ? 4.0 : 4.5)
        << ground.name().toStdString();
}

TEST_P(MainWindowTest, TheFanHasMostOfTheWidth) {
    openScan(60);
    QTest::qWait(10);
    EXPECT_GE(window_.fan().width(), window_.width() * 6 / 10);
}

INSTANTIATE_TEST_SUITE_P(Palettes, MainWindowTest, testing::Values(Theme::Day, Theme::Dusk, Theme::Night),
                         [](const auto& test) { return themeName(test.param).toStdString(); });

TEST(MainWindow, AParameterChangedInTheFormReachesTheRunningPipeline) {
    MainWindow window({.remember = false, .play_on_open = false});
    window.show();
    window.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window.bridge().isOpen(); }));
    ParameterModel& model = window.parameters().model();
    const auto& infos = model.infos();
    const auto named =
        std::find_if(infos.begin(), infos.end(), [](const auto& info) { return info.name == "sound_speed"; });
    ASSERT_NE(named, infos.end());
    model.setData(model.indexOf(static_cast<std::size_t>(named - infos.begin())), "1500");
    const auto before = window.bridge().status().revision;
    EXPECT_EQ(window.bridge().params().head.sound_speed, 1500.0);
    EXPECT_EQ(model.sentCount(), 1) << "not before the run says so";
    ASSERT_TRUE(await([&] { return window.bridge().status().revision > before; }));
    ASSERT_TRUE(await([&] { return model.sentCount() == 0; }));
    const auto row = static_cast<std::size_t>(named - infos.begin());
    EXPECT_TRUE(model.indexOf(row, ParameterModel::State).data().toString().contains("in force"));
}

TEST(MainWindow, ADroppedFileIsOpened) {
    MainWindow window({.remember = false});
    window.show();
    QStringList opening;
    QObject::connect(&window.bridge(), &PipelineBridge::opening, [&](const QString& name) { opening << name; });
    QMimeData dragged;
    dragged.setUrls({QUrl::fromLocalFile("/no/such/harbour.V4LOG")});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent drop({10, 10}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    EXPECT_EQ(opening, QStringList{"harbour.V4LOG"});
}

TEST(MainWindow, ThePaletteCycleNeverJumpsFromNightToDay) {
    MainWindow window({.remember = false});
    window.setTheme(Theme::Day);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    std::vector<int> brightness;
    for (int press = 0; press < 4; ++press) {
        QTest::keyClick(&window, Qt::Key_F5);
        brightness.push_back(qGray(QApplication::palette().color(QPalette::Window).rgb()));
    }
    EXPECT_LT(brightness[1], brightness[0]) << "dusk, then night";
    EXPECT_EQ(brightness[2], brightness[0]) << "dusk again";
    EXPECT_GT(brightness[3], 200) << "day";
}

TEST(MainWindow, TypingIntoAFieldTriggersNoShortcut) {
    MainWindow window({.remember = false, .play_on_open = false});
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    window.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window.bridge().status().state == ReplayState::Paused; }));
    QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
    QWidget* field = QApplication::focusWidget();
    ASSERT_NE(qobject_cast<QLineEdit*>(field), nullptr);
    QTest::keyClicks(field, "s w.,?");
    EXPECT_EQ(qobject_cast<QLineEdit*>(field)->text(), "s w.,?");
    EXPECT_EQ(window.bridge().speed(), 1.0);
    QTest::qWait(50);
    window.bridge().poll();
    EXPECT_EQ(window.bridge().status().state, ReplayState::Paused);
    EXPECT_TRUE(window.messages().text().isEmpty()) << "no picture was taken";
}

TEST(MainWindow, TheKeysSheetOpensAndCloses) {
    MainWindow window({.remember = false});
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_Question);
    auto* sheet = window.findChild<ShortcutsOverlay*>();
    ASSERT_NE(sheet, nullptr);
    EXPECT_TRUE(sheet->isVisible());
    QTest::keyClick(sheet, Qt::Key_Escape);
    EXPECT_FALSE(sheet->isVisible());
}

TEST(MainWindow, LayoutAndPaletteAreRememberedWhenAsked) {
    {
        MainWindow window({.remember = true});
        window.setTheme(Theme::Night);
        window.show();
        window.close();
    }
    EXPECT_EQ(QSettings().value("palette").toString(), themeName(Theme::Night));
    EXPECT_FALSE(QSettings().value("layout_operate").toByteArray().isEmpty());
    QSettings().clear();
}

TEST(MainWindow, APictureThatCannotBeWrittenIsSaid) {
    MainWindow window({.remember = false});
    window.show();
    EXPECT_FALSE(window.saveScreenshot("/no/such/folder/picture.png"));
    EXPECT_TRUE(window.messages().isVisible());
    const QTemporaryDir folder;
    EXPECT_TRUE(window.saveScreenshot(folder.filePath("picture.png")));
}

TEST(MainWindow, OneUndoTakesBackMarksAndParametersAlike) {
    MainWindow window({.remember = false, .play_on_open = false});
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    window.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window.bridge().status().state == ReplayState::Paused; }));
    window.bridge().seekPosition(30);
    ASSERT_TRUE(await([&] { return window.bridge().scene() && window.bridge().scene()->position == 30; }));
    QTest::keyClick(&window.fan(), Qt::Key_M);
    ASSERT_EQ(window.marks().rowCount(), 1);
    ParameterModel& model = window.parameters().model();
    PipelineBridge::Params changed = window.bridge().params();
    changed.regions.screen.seed_excess_db = 17.0;
    model.change(parameterValues(changed), "threshold");
    EXPECT_EQ(window.bridge().params().regions.screen.seed_excess_db, 17.0);
    QTest::keyClick(&window.fan(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(window.bridge().params().regions.screen.seed_excess_db, 17.0);
    EXPECT_EQ(window.marks().rowCount(), 1);
    QTest::keyClick(&window.fan(), Qt::Key_M);
    QTest::keyClick(&window.fan(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window.marks().rowCount(), 1);
}

TEST(StatusBar, CallsTheTargetByItsName) {
    StatusBar bar;
    bar.showSource({});
    bar.setTrackNames({{1, "buoy"}});
    bar.showScene(test::fullScene());
    const auto chips = bar.findChildren<StatusChip*>();
    EXPECT_TRUE(std::any_of(chips.begin(), chips.end(), [](const StatusChip* chip) {
        return chip->accessibleName().startsWith("TRACK T01 buoy confirmed");
    }));
}

TEST(MainWindow, KeysTurnTheFanMeasureAndBringTheBeamToTheFront) {
    MainWindow window({.remember = false, .play_on_open = false});
    window.resize(1600, 1000);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    window.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window.bridge().status().state == ReplayState::Paused; }));
    QTest::keyClick(&window, Qt::Key_N);
    EXPECT_EQ(window.fan().orientation(), Orientation::NorthUp);
    QTest::keyClick(&window, Qt::Key_N);
    EXPECT_EQ(window.fan().orientation(), Orientation::CourseUp);
    QTest::keyClick(&window, Qt::Key_F4);
    EXPECT_TRUE(window.fan().measures());
    QTest::keyClick(&window, Qt::Key_F4);
    EXPECT_FALSE(window.fan().measures());
    auto* beam = window.findChild<BeamPanel*>();
    ASSERT_NE(beam, nullptr);
    EXPECT_TRUE(beam->visibleRegion().isEmpty()) << "behind the time line";
    QTest::keyClick(&window, Qt::Key_B);
    EXPECT_FALSE(beam->visibleRegion().isEmpty());
}

TEST(MainWindow, MarksAndZonesComeBackWithTheirRecording) {
    QSettings().clear();
    const auto open = [](MainWindow& window) {
        window.show();
        window.bridge().open("scan", test::scanOpener(60));
        ASSERT_TRUE(await([&] { return window.bridge().isOpen(); }));
    };
    {
        MainWindow window({.remember = true, .play_on_open = false});
        open(window);
        window.marks().add({3.0, 4.0}, {}, "net?");
        window.areas().add({Area::Kind::Guard, "ahead", true, {{1.0F, -1.0F}, {5.0F, -1.0F}, {5.0F, 1.0F}}});
    }
    MainWindow window({.remember = true, .play_on_open = false});
    EXPECT_EQ(window.marks().rowCount(), 0) << "its recording is not open";
    EXPECT_EQ(window.areas().rowCount(), 1) << "goes with the vehicle";
    open(window);
    ASSERT_EQ(window.marks().rowCount(), 1);
    EXPECT_EQ(window.marks().marks()[0].text, "net?");
    EXPECT_EQ(window.areas().rowCount(), 1);
    window.bridge().close();
    EXPECT_EQ(window.marks().rowCount(), 0) << "their ground is gone";
    QSettings().clear();
}

TEST(StatusBar, TellsTheShareOfTheTrackersLastMessagesThatWereLost) {
    StatusBar bar;
    LiveState state;
    state.tracker.emplace();
    state.tracker->link = {true, {}, 0.2};
    const auto tracker_chip = [&](quint64 messages, quint64 gaps) {
        state.tracker->messages = messages;
        state.tracker->gaps = gaps;
        bar.showLive(state, 1.0);
        for (const auto* chip : bar.findChildren<StatusChip*>())
            if (chip->accessibleName().startsWith("TRACKER ")) return chip->accessibleName();
        return QString();
    };
    EXPECT_FALSE(tracker_chip(100, 0).contains("lost"));
    EXPECT_TRUE(tracker_chip(180, 20).contains("20 % lost")) << tracker_chip(180, 20).toStdString();
    EXPECT_TRUE(tracker_chip(181, 20).contains("20 % lost")) << "one message more says nothing yet";
    EXPECT_FALSE(tracker_chip(300, 20).contains("lost")) << "of the last ones";
    EXPECT_FALSE(tracker_chip(5, 0).contains("lost")) << "another link";
}

TEST(StatusChip, ShowsAsManyWholePartsOfItsDetailAsThereIsRoomFor) {
    const auto picture = [](const QString& detail, int room) {
        StatusChip chip;
        chip.show(StatusChip::Health::Good, "up", detail);
        EXPECT_LE(chip.giveRoom(room), room);
        chip.resize(400, chip.sizeHint().height());
        return chip.grab().toImage();
    };
    StatusChip whole;
    whole.show(StatusChip::Health::Good, "up", "0.1 s  310 ms");
    const int least = whole.sizeHint().width(), room = whole.giveRoom(1'000);
    EXPECT_EQ(whole.sizeHint().width(), least + room);
    EXPECT_EQ(picture("0.1 s  310 ms", room - 1), picture("0.1 s", room - 1));
    EXPECT_NE(picture("0.1 s  310 ms", room - 1), picture("", room - 1));
    EXPECT_NE(picture("0.1 s  310 ms", room), picture("0.1 s", room));
    EXPECT_EQ(picture("0.1 s  310 ms", 3), picture("", 3));
    whole.show(StatusChip::Health::Degraded, "up", "0.1 s  310 ms");
    EXPECT_EQ(whole.giveRoom(0), 0);
    EXPECT_GE(whole.minimumSizeHint().width(), least + room) << "what is wrong is always told";
}

}  // namespace
}  // namespace echotrail
