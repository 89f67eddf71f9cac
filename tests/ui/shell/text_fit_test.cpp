#include "qt_environment.hpp"
#include "ui/language/language.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOptionButton>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

namespace echotrail {
namespace {

using test::await;

QString plain(QString text) { return text.remove('&'); }

/// Room for the widget's text less what the text needs, px; 0 where it has none, or is meant to be shortened.
int spare(const QWidget& widget) {
    const auto needs = [&](const QString& text) { return widget.fontMetrics().horizontalAdvance(plain(text)); };
    if (widget.sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) return 0;
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        if (label->wordWrap()) return label->height() - label->heightForWidth(label->width());
        int widest = 0;
        for (const QString& line : label->text().split('\n')) widest = std::max(widest, needs(line));
        return label->text().isEmpty() ? 0 : label->contentsRect().width() - 2 * label->margin() - widest;
    }
    if (const auto* chip = qobject_cast<const StatusChip*>(&widget))
        return chip->width() - chip->minimumSizeHint().width();
    if (const auto* box = qobject_cast<const QCheckBox*>(&widget)) return box->width() - box->sizeHint().width();
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        const QRect field =
            combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
        return combo->isEditable() ? 0 : field.width() - needs(combo->currentText());
    }
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return button->text().isEmpty() ? 0 : button->width() - needs(button->text()) - 4;
    if (const auto* field = qobject_cast<const QLineEdit*>(&widget))
        return field->placeholderText().isEmpty() ? 0 : field->width() - needs(field->placeholderText()) - 4;
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) {
        int least = 0;
        for (int i = 0; i < tabs->count(); ++i)
            least = std::min(least, tabs->tabRect(i).width() - needs(tabs->tabText(i)));
        return least;
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) {
        int least = 0;
        for (int i = 0; i < header->count() && header->orientation() == Qt::Horizontal; ++i) {
            if (header->isSectionHidden(i)) continue;
            const QString title = header->model()->headerData(i, Qt::Horizontal).toString();
            if (!title.isEmpty()) least = std::min(least, header->sectionSize(i) - needs(title) - 4);
        }
        return least;
    }
    return 0;
}

/// What of a widget is on the screen once everything in it has been scrolled to: cut at the sides only.
bool isCutAtASide(const QWidget& widget) {
    QRect shown = widget.rect();
    const QWidget* child = &widget;
    for (const QWidget* parent = widget.parentWidget(); parent && !child->isWindow(); parent = child->parentWidget()) {
        shown.translate(child->pos());
        if (shown.left() < 0 || shown.right() >= parent->width()) return true;
        child = parent;
    }
    return false;
}

struct Case {
    Language language;
    double scale;
};

class TextFit : public testing::TestWithParam<Case> {
protected:
    TextFit() {
        applyFontScale(*qApp, GetParam().scale);
        window_ = std::make_unique<MainWindow>(MainWindow::Options{.remember = false,
                                                                   .play_on_open = false,
                                                                   .language = languageName(GetParam().language),
                                                                   .steady_alerts = true});
        window_->resize(1920, 1080);
        window_->show();
        EXPECT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    }
    ~TextFit() override {
        window_.reset();
        applyFontScale(*qApp, 1.0);
        applyLanguage(*qApp, Language::English);
    }
    void check(const std::string& where) {
        QTest::qWait(20);
        EXPECT_LE(window_->width(), 1920) << where << ": the window has become wider than the screen" << leastSizes();
        EXPECT_LE(window_->height(), 1080) << where << ": the window has become higher than the screen" << leastSizes();
        for (const QWidget* widget : window_->findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->visibleRegion().isEmpty()) continue;
            const QString text = widget->property("text").toString();
            const std::string who = where + ", " + widget->metaObject()->className() + " '" +
                                    (text.isEmpty() ? widget->accessibleName() : text).toStdString() + "'";
            EXPECT_GE(spare(*widget), 0) << who;
            const bool text_widget =
                qobject_cast<const QLabel*>(widget) || qobject_cast<const QAbstractButton*>(widget);
            if (text_widget && !text.isEmpty()) {
                EXPECT_FALSE(isCutAtASide(*widget)) << who << " is cut at a side";
            }
        }
    }

    /// What each part insists on.
    std::string leastSizes() const {
        QString sizes;
        const auto add = [&](const QString& name, const QWidget& part) {
            const QSize least = part.minimumSizeHint().expandedTo(part.minimumSize());
            sizes += QString("\n  %1 %2 × %3").arg(name).arg(least.width()).arg(least.height());
        };
        add("centre", *window_->centralWidget());
        for (const QDockWidget* dock : window_->findChildren<QDockWidget*>()) add(dock->objectName(), *dock);
        return sizes.toStdString();
    }

    std::unique_ptr<MainWindow> window_;
};

TEST_P(TextFit, NoTextIsCutOnTheStartPageAndInAnyPanel) {
    check("start page");
    window_->bridge().open("scan", test::scanOpener(60));
    ASSERT_TRUE(await([&] { return window_->bridge().status().state == ReplayState::Paused; }));
    window_->bridge().seekPosition(55);
    ASSERT_TRUE(await([&] { return window_->bridge().scene() && window_->bridge().scene()->position == 55; }));
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
        dock->raise();
        check(dock->objectName().toStdString());
    }
}

INSTANTIATE_TEST_SUITE_P(Scales, TextFit,
                         testing::Values(Case{Language::English, 1.0}, Case{Language::Chinese, 1.0},
                                         Case{Language::English, 1.5}, Case{Language::Chinese, 1.5}),
                         [](const auto& test) {
                             return languageName(test.param.language).toStdString() +
                                    (test.param.scale > 1.0 ? "_large" : "_usual");
                         });

}  // namespace
}  // namespace echotrail
