#include "qt_environment.hpp"
#include "ui/chart/mark_model.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/tour_panel.hpp"
#include "ui/manual/manual_view.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/panels/tracks/tracks_panel.hpp"
#include "ui/views/fan_view.hpp"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTest>
#include <QTextBrowser>
#include <QTreeView>

namespace echotrail {
namespace {

using test::await;

const QStringList& handWritten() {
    static const QStringList names{"start",      "fan",  "status", "connection", "layers",    "chart",   "tracks",
                                   "parameters", "plan", "alerts", "beam",       "time_line", "windows", "keys"};
    return names;
}

class HelpTest : public testing::Test {
protected:
    HelpTest() {
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    ~HelpTest() override { applyLanguage(*qApp, Language::English); }
    QDockWidget* dock(const QString& name) { return window_.findChild<QDockWidget*>(name); }

    MainWindow window_{{.remember = false,
                        .play_on_open = false,
                        .libraries = {{"Tinyqueue", "7.1", "MIT", "queues"}}}};
};

TEST_F(HelpTest, EveryDockHasItsPageInBothLanguages) {
    for (const Language language : {Language::English, Language::Chinese}) {
        const ManualBook book(language);
        ASSERT_EQ(book.pages().size(), handWritten().size());
        for (const QString& name : handWritten()) {
            ASSERT_NE(book.page(name), nullptr) << name.toStdString();
            EXPECT_TRUE(book.page(name)->text.startsWith("# ")) << name.toStdString();
            EXPECT_FALSE(book.page(name)->title().isEmpty());
        }
        for (const QDockWidget* dock : window_.findChildren<QDockWidget*>())
            if (dock->objectName() != "manual" && dock->objectName() != "tour") {
                EXPECT_NE(book.page(dock->objectName()), nullptr) << dock->objectName().toStdString();
            }
    }
}

TEST_F(HelpTest, LinksAndPicturesOfThePagesLeadSomewhere) {
    static const QRegularExpression link(R"(\]\(([^)]+)\))");
    for (const Language language : {Language::English, Language::Chinese}) {
        window_.setLanguage(language);
        QTest::qWait(1);
        const ManualBook& book = window_.manual().book();
        int links = 0;
        for (const ManualPage& page : book.pages())
            for (auto found = link.globalMatch(page.text); found.hasNext(); ++links) {
                const QUrl url(found.next().captured(1));
                if (url.scheme() == "qrc") {
                    EXPECT_TRUE(QFile::exists(":" + url.path())) << url.toString().toStdString();
                } else {
                    EXPECT_NE(book.page(url.path()), nullptr) << url.toString().toStdString();
                }
            }
        EXPECT_GT(links, 10);
    }
}

TEST_F(HelpTest, TheReferencesAreWhatTheProgramSaysOfItself) {
    const ManualBook& book = window_.manual().book();
    for (const ParameterInfo& info : window_.parameters().model().infos())
        EXPECT_TRUE(book.page("parameters")->text.contains(QString::fromStdString("**" + info.name + "**")))
            << info.name;
    const QString& keys = book.page("keys")->text;
    int actions = 0;
    for (const QMenu* menu : window_.menuBar()->findChildren<QMenu*>())
        for (const QAction* action : menu->actions()) {
            if (action->shortcut().isEmpty()) continue;
            ++actions;
            EXPECT_TRUE(keys.contains(action->shortcut().toString(QKeySequence::NativeText)))
                << action->text().toStdString();
        }
    EXPECT_GT(actions, 40);
    EXPECT_TRUE(book.page("about")->text.contains("| Tinyqueue | 7.1 | MIT | queues |"));
    EXPECT_TRUE(book.page("licence")->text.contains("GNU GENERAL PUBLIC LICENSE"));
}

TEST_F(HelpTest, F1OpensThePageOfWhatHasTheFocusOrIsPointedAt) {
    QTest::mouseMove(&window_, window_.rect().center());
    QTest::keyClick(&window_, Qt::Key_F1);
    EXPECT_EQ(window_.manual().page(), "start") << "nothing is open";
    EXPECT_TRUE(dock("manual")->isVisible());
    QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
    window_.parameters().form().tree().setCurrentIndex(window_.parameters().form().tree().model()->index(0, 0));
    QTest::keyClick(&window_, Qt::Key_F1);
    EXPECT_EQ(window_.manual().page(), "parameters");
    window_.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window_.bridge().isOpen(); }));
    window_.fan().setFocus();
    QTest::keyClick(&window_, Qt::Key_F1);
    EXPECT_EQ(window_.manual().page(), "fan");
    QTest::keyClick(&window_, Qt::Key_F1);
    EXPECT_EQ(window_.manual().page(), "fan") << "again is no other page";
}

TEST_F(HelpTest, AWordIsFoundAndItsLinkOpensThePageThere) {
    EXPECT_FALSE(window_.manual().book().find("seed_excess_db").isEmpty());
    EXPECT_TRUE(window_.manual().book().find("qwertzuiop").isEmpty());
    window_.showManual("start");
    auto* field = window_.manual().findChild<QLineEdit*>();
    auto* browser = window_.manual().findChild<QTextBrowser*>();
    QTest::keyClicks(field, "guard zone");
    EXPECT_TRUE(browser->toMarkdown().contains("manual:chart?guard%20zone")) << browser->toMarkdown().toStdString();
    Q_EMIT browser->anchorClicked(QUrl("manual:chart?guard%20zone"));
    EXPECT_EQ(window_.manual().page(), "chart");
    EXPECT_EQ(browser->textCursor().selectedText().toLower(), "guard zone");
    window_.setLanguage(Language::Chinese);
    QTest::qWait(1);
    EXPECT_EQ(window_.manual().page(), "chart");
    EXPECT_FALSE(window_.manual().book().find(QString::fromUtf8("警戒区")).isEmpty());
}

TEST_F(HelpTest, ADroppedTrackComesBackWithUndo) {
    window_.bridge().open("scan", test::scanOpener(150));
    ASSERT_TRUE(await([&] { return window_.bridge().status().state == ReplayState::Paused; }));
    const auto tracksAt = [&](quint64 position) {
        window_.bridge().seekPosition(position);
        EXPECT_TRUE(await([&] { return window_.bridge().scene() && window_.bridge().scene()->position == position; }));
        return window_.bridge().scene()->tracks.size();
    };
    ASSERT_EQ(tracksAt(100), 1u);
    QTest::keyClick(&window_.fan(), Qt::Key_Delete, Qt::ShiftModifier);
    EXPECT_TRUE(await([&] { return window_.bridge().scene()->tracks.empty(); }));
    EXPECT_EQ(tracksAt(120), 0u);
    QTest::keyClick(&window_.fan(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(await([&] { return window_.bridge().scene()->tracks.size() == 1; }));
}

TEST(FirstStart, ShowsTheDemonstrationAndATourUntilItWasGoneThrough) {
    QSettings().clear();
    {
        MainWindow window({.remember = true, .play_on_open = false});
        window.show();
        window.greet();
        ASSERT_TRUE(await([&] { return window.bridge().isOpen(); }));
        auto* dock = window.findChild<QDockWidget*>("tour");
        auto* tour = window.findChild<TourPanel*>();
        EXPECT_TRUE(dock->isVisible());
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
        const auto press = [&](const QString& text) {
            for (auto* button : tour->findChildren<QPushButton*>())
                if (button->text() == text) button->click();
        };
        press("Next");
        EXPECT_EQ(tour->step(), TourPanel::Mark);
        window.marks().add({1.0, 2.0}, {}, "");
        press("Next");
        press("Finish");
        EXPECT_FALSE(dock->isVisible());
    }
    MainWindow window({.remember = true, .play_on_open = false});
    window.show();
    window.greet();
    EXPECT_FALSE(window.bridge().isOpening());
    EXPECT_FALSE(window.findChild<QDockWidget*>("tour")->isVisible());
    QSettings().clear();
}

}  // namespace
}  // namespace echotrail
