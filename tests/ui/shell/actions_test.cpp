#include "qt_environment.hpp"
#include "ui/language/language.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <algorithm>
#include <map>
#include <set>

namespace echotrail {
namespace {

/// What can be chosen, of a menu and the menus in it.
void gather(QMenu& menu, std::set<QAction*>& found) {
    Q_EMIT menu.aboutToShow();  // some are filled only then
    for (QAction* action : menu.actions()) {
        if (QMenu* below = action->menu())
            gather(*below, found);
        else if (!action->isSeparator())
            found.insert(action);
    }
}

/// A head that is not there, so that what is for live heads is in the menus, too.
LiveAccess noHeads() {
    LiveAccess access;
    access.open = [](const LiveRequest&) -> Result<std::unique_ptr<LiveSource>> { return Error{"no heads here"}; };
    access.open_tracker = [](const QString&, bool) -> Result<std::unique_ptr<LiveSource>> { return Error{"none here"}; };
    return access;
}

bool isChinese(const QString& text) {
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.script() == QChar::Script_Han; });
}

class Actions : public testing::TestWithParam<Language> {
protected:
    Actions() {
        window_.show();
        window_.setLanguage(GetParam());
        QTest::qWait(1);
        for (const QAction* title : window_.menuBar()->actions()) gather(*title->menu(), in_menus_);
        for (QMenu* menu : window_.parameters().findChildren<QMenu*>())
            if (menu->menuAction()->associatedObjects().size() < 2) gather(*menu, in_menus_);
    }
    ~Actions() override { applyLanguage(*qApp, Language::English); }

    MainWindow window_{{.remember = false, .play_on_open = false, .steady_alerts = true, .live = noHeads()}};
    std::set<QAction*> in_menus_;
};

TEST_P(Actions, EachSaysInTheFootWhatItDoes) {
    EXPECT_GT(in_menus_.size(), 80U);
    for (const QAction* action : in_menus_) EXPECT_GT(action->statusTip().size(), 4) << action->text().toStdString();
}

TEST_P(Actions, EachHasAShortcutOrAPlaceInAMenu) {
    for (QAction* action : window_.findChildren<QAction*>()) {
        if (action->isSeparator() || action->text().isEmpty() || action->menu()) continue;
        const bool reachable = in_menus_.contains(action) || !action->shortcut().isEmpty();
        const bool of_qt = action->parent()->inherits("QLineEdit") || action->parent()->inherits("QToolBar");
        const bool of_tour = action->parent()->objectName() == "tour";  // Help → Tour shows it, with the demonstration
        EXPECT_TRUE(reachable || of_qt || of_tour) << action->text().toStdString();
    }
}

TEST_P(Actions, NoTwoShareAKeyAndNoTwoOfAMenuALetter) {
    std::map<QString, QString> keys;
    for (const QAction* action : in_menus_)
        for (const QKeySequence& key : action->shortcuts()) {
            const auto [other, is_new] = keys.emplace(key.toString(), action->text());
            EXPECT_TRUE(is_new) << key.toString().toStdString() << ": " << action->text().toStdString() << " and "
                                << other->second.toStdString();
        }
    for (const QAction* title : window_.menuBar()->actions()) {
        std::map<QString, QString> letters;
        for (const QAction* action : title->menu()->actions()) {
            const QKeySequence letter = QKeySequence::mnemonic(action->text());
            if (letter.isEmpty()) continue;
            const auto [other, is_new] = letters.emplace(letter.toString(), action->text());
            EXPECT_TRUE(is_new) << action->text().toStdString() << " and " << other->second.toStdString();
        }
    }
}

TEST_P(Actions, AreInTheLanguageInForce) {
    for (const QAction* action : in_menus_) {
        const bool own_name = action->text() == "English" || action->statusTip().startsWith('/') ||
                              action->text() == "kalman" || action->text() == "paper";
        if (!own_name) {
            EXPECT_EQ(isChinese(action->text()), GetParam() == Language::Chinese || action->text() == "中文")
                << action->text().toStdString();
        }
        EXPECT_EQ(isChinese(action->statusTip()), GetParam() == Language::Chinese) << action->statusTip().toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, Actions, testing::Values(Language::English, Language::Chinese),
                         [](const auto& test) { return languageName(test.param).toStdString(); });

}  // namespace
}  // namespace echotrail
