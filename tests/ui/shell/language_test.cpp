#include "ui/language/language.hpp"

#include "qt_environment.hpp"
#include "ui/alerts/alert_centre.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/status_chip.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QHeaderView>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace echotrail {
namespace {

using test::await;

class LanguageTest : public testing::Test {
protected:
    LanguageTest() {
        window_.resize(1600, 1000);
        window_.show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
    }
    ~LanguageTest() override { applyLanguage(*qApp, Language::English); }
    void speak(Language language) {
        window_.setLanguage(language);
        QTest::qWait(1);
    }
    QStringList menus() {
        QStringList titles;
        for (const QAction* action : window_.menuBar()->actions()) titles << action->text();
        return titles;
    }
    QString dock(const QString& name) { return window_.findChild<QDockWidget*>(name)->windowTitle(); }

    MainWindow window_{{.remember = false, .play_on_open = false, .steady_alerts = true}};
};

TEST_F(LanguageTest, MenusDocksAndTheBarChangeWhileTheWindowIsOpenAndBack) {
    const QStringList english = menus();
    ASSERT_TRUE(english.contains("&File"));
    speak(Language::Chinese);
    EXPECT_EQ(menus().size(), english.size());
    EXPECT_TRUE(menus().contains(QString::fromUtf8("文件(&F)"))) << menus().join(' ').toStdString();
    EXPECT_EQ(dock("tracks"), QString::fromUtf8("航迹"));
    bool told = false;
    for (const auto* chip : window_.findChildren<StatusChip*>())
        told |= chip->accessibleName().startsWith(QString::fromUtf8("告警 "));
    EXPECT_TRUE(told);
    speak(Language::English);
    EXPECT_EQ(menus(), english);
    EXPECT_EQ(dock("tracks"), "Tracks");
}

TEST_F(LanguageTest, KeysAndWhatCannotActAreTheSameInBoth) {
    window_.bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window_.bridge().status().state == ReplayState::Paused; }));
    speak(Language::Chinese);
    QTest::keyClick(&window_, Qt::Key_Right, Qt::ControlModifier);
    EXPECT_TRUE(await([&] { return window_.bridge().status().position == 1; })) << "the menu still reaches the run";
    window_.alerts().setSound({});
    window_.alerts().guardZoneEntered(3, "N");
    QTest::keyClick(&window_, Qt::Key_A);
    EXPECT_EQ(window_.alerts().summary().alarms, 0) << "once, not twice: no key is ambiguous";
    window_.bridge().close();
    for (const QMenu* menu : window_.menuBar()->findChildren<QMenu*>())
        for (const QAction* action : menu->actions())
            if (action->shortcut() == QKeySequence(Qt::Key_Space)) {
                EXPECT_FALSE(action->isEnabled());
            }
}

/// Every text there is: of widgets with class and name, of the columns of tables.
QStringList textsOf(const QWidget& window) {
    QStringList texts;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        const QString who = QString("%1 %2: ").arg(widget->metaObject()->className(), widget->objectName());
        for (const char* property : {"text", "title", "placeholderText", "currentText", "windowTitle", "toolTip",
                                     "statusTip", "accessibleName", "accessibleDescription"}) {
            const QString text = widget->property(property).toString();
            if (!text.isEmpty()) texts << who + property + " " + text;
        }
        if (const auto* header = qobject_cast<const QHeaderView*>(widget); header && header->model())
            for (int i = 0; i < header->count(); ++i)
                texts << who + header->model()->headerData(i, header->orientation()).toString();
    }
    for (const QAction* action : window.findChildren<QAction*>()) texts << action->text() + " " + action->statusTip();
    texts.sort();
    return texts;
}

/// A change while the window is open must come to the same as a start in that language: in each text, and on the
/// screen, where much is painted.
TEST(Languages, AWindowThatChangedIsLikeOneThatWasStartedSo) {
    const auto make = [](const QString& language) {
        auto window = std::make_unique<MainWindow>(
            MainWindow::Options{.remember = false, .play_on_open = false, .language = language, .steady_alerts = true});
        window->resize(1600, 1000);
        window->show();
        return window;
    };
    const auto open = [](MainWindow& window) {
        window.bridge().open("scan", test::scanOpener(60));
        ASSERT_TRUE(await([&] { return window.bridge().status().state == ReplayState::Paused; }));
        window.bridge().designate(14.7, 0.07);
        window.bridge().seekPosition(50);
        ASSERT_TRUE(await([&] { return window.bridge().scene() && window.bridge().scene()->position == 50; }));
        QTest::qWait(20);
    };
    const auto layAnew = [](MainWindow& window) {
        const QString reset = QCoreApplication::translate("echotrail::MainWindow", "&Reset layout");
        for (QAction* action : window.findChildren<QAction*>())
            if (action->text() == reset) action->trigger();
        QTest::qWait(20);
    };
    const auto compare = [&](MainWindow& changed, MainWindow& started, const char* what) {
        const QStringList have = textsOf(changed);
        const QStringList want = textsOf(started);
        for (const QString& text : have)
            if (!want.contains(text)) ADD_FAILURE() << what << ", left over: " << text.toStdString();
        for (const QString& text : want)
            if (!have.contains(text)) ADD_FAILURE() << what << ", missing: " << text.toStdString();
        for (MainWindow* window : {&changed, &started}) layAnew(*window);  // English words had asked for more room
        if (changed.grab().toImage() == started.grab().toImage()) return;
        const QString path = QDir::temp().filePath("echotrail_language_%1.png");
        changed.grab().save(path.arg("changed"));
        started.grab().save(path.arg("started"));
        ADD_FAILURE() << what << ": the pictures differ, see " << path.arg("*").toStdString();
    };
    auto changed = make("en");
    changed->setLanguage(Language::Chinese);
    QTest::qWait(20);
    auto started = make("zh");
    QTest::qWait(20);
    compare(*changed, *started, "start page");
    open(*changed);
    open(*started);
    compare(*changed, *started, "opened after the change");
    changed->setLanguage(Language::English);
    QTest::qWait(20);
    changed->setLanguage(Language::Chinese);
    QTest::qWait(20);
    compare(*changed, *started, "changed with a recording open");
    started.reset();
    changed.reset();
    applyLanguage(*qApp, Language::English);
}

TEST_F(LanguageTest, AlertsSpeakTheLanguageInForce) {
    speak(Language::Chinese);
    window_.alerts().guardZoneEntered(3, "N");
    EXPECT_EQ(window_.alerts().model().index(0).data().toString(), QString::fromUtf8("T03 进入警戒区 N"));
    speak(Language::English);
    EXPECT_EQ(window_.alerts().model().index(0).data().toString(), "T03 in guard zone N") << "though it is over";
}

TEST_F(LanguageTest, AlertsThatHaveEndedSpeakItToo) {
    AlertCentre& alerts = window_.alerts();
    alerts.setSound({});
    Timestamp now{std::chrono::hours(1)};
    alerts.setClock([&] { return now; });
    LiveState state;
    state.sonar = {true, {}, 0.1};
    state.run.recorder.error = "no space left";
    alerts.showLive(state, 5.0);
    now += std::chrono::seconds(10);
    state.run.recorder.error.clear();
    alerts.showLive(state, 5.0);
    alerts.acknowledgeMostUrgent();
    const QModelIndex ended = alerts.model().index(0);
    ASSERT_TRUE(ended.data(AlertModel::OverRole).toBool());
    EXPECT_EQ(ended.data().toString(), "Recording has ended");
    speak(Language::Chinese);
    EXPECT_EQ(ended.data().toString(), QString::fromUtf8("记录已停止"));
    EXPECT_EQ(ended.data(AlertModel::CauseRole).toString(), QString::fromUtf8("no space left · 请清理磁盘后重新连接"));
}

TEST(Languages, HaveNamesForFilesAndForPeople) {
    for (const Language language : {Language::English, Language::Chinese})
        EXPECT_EQ(languageFromName(languageName(language)), language);
    EXPECT_EQ(languageFromName("tlh"), Language::English);
}

/// The sources are read again as the translator's tool reads them, so that a new text cannot be forgotten.
TEST(Languages, EveryTextHasItsTranslation) {
    const QString source = ECHOTRAIL_SOURCE_DIR;
    const QTemporaryDir folder;
    const QString catalogue = folder.filePath("echotrail_zh.ts");
    ASSERT_TRUE(QFile::copy(source + "/resources/translations/echotrail_zh.ts", catalogue));
    QProcess lupdate;
    lupdate.setWorkingDirectory(source);
    lupdate.start(ECHOTRAIL_LUPDATE,
                  {"-silent", "-no-obsolete", "-locations", "none", "-I", ".", "ui", "-ts", catalogue});
    ASSERT_TRUE(lupdate.waitForFinished(120'000));
    ASSERT_EQ(lupdate.exitCode(), 0);
    QFile file(catalogue);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    EXPECT_GT(text.count("<message"), 400);
    static const QRegularExpression unfinished(
        R"(<source>([^<]*)</source>\s*(?:<comment>[^<]*</comment>\s*)?<translation type="unfinished")");
    for (auto found = unfinished.globalMatch(text); found.hasNext();)
        ADD_FAILURE() << "not translated: " << found.next().captured(1).toStdString();
}

/// %1 and the like must be there in both.
TEST(Languages, TranslationsKeepWhatIsFilledIn) {
    QFile file(QString(ECHOTRAIL_SOURCE_DIR) + "/resources/translations/echotrail_zh.ts");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    static const QRegularExpression message(R"(<source>([^<]*)</source>\s*<translation>([^<]*)</translation>)");
    static const QRegularExpression place("%[0-9n]");
    const auto places = [](const QString& words) {
        QStringList all;
        for (auto found = place.globalMatch(words); found.hasNext();) all << found.next().captured();
        all.sort();
        return all;
    };
    for (auto found = message.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();) {
        const auto match = found.next();
        EXPECT_EQ(places(match.captured(1)), places(match.captured(2))) << match.captured(1).toStdString();
    }
}

}  // namespace
}  // namespace echotrail
