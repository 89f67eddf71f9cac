#include "ui/chart/mark_model.hpp"
#include "ui/main_window/dock_title.hpp"
#include "ui/main_window/main_window.hpp"
#include "ui/main_window/shortcuts_overlay.hpp"
#include "ui/main_window/start_page.hpp"
#include "ui/main_window/status_bar.hpp"
#include "ui/main_window/tour_panel.hpp"
#include "ui/manual/manual_view.hpp"
#include "ui/panels/parameters/parameter_panel.hpp"
#include "ui/style/upright_scroll.hpp"
#include "ui/views/fan_view.hpp"

#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QDockWidget>
#include <QMenuBar>
#include <QMouseEvent>
#include <QSettings>

// What helps a newcomer: the manual on F1, the tour of the first start, versions and licences.

namespace echotrail {
namespace {

constexpr auto page_property = "manual_page";
constexpr auto tour_setting = "tour_done";

/// The page of the manual about a widget: its own, or that of the dock it is in.
QString pageAbout(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget()) {
        if (const QString page = widget->property(page_property).toString(); !page.isEmpty()) return page;
        if (qobject_cast<const QDockWidget*>(widget)) return widget->objectName();
    }
    return {};
}

}  // namespace

void MainWindow::makeHelp() {
    fan_->setProperty(page_property, "fan");
    start_->setProperty(page_property, "start");
    status_->setProperty(page_property, "status");
    menuBar()->setProperty(page_property, "keys");
    manual_ = new ManualView(
        [this](ManualBook& book) {
            book.add("parameters", parameterReference());
            book.add("keys", keyReference(*menuBar()));
            book.add("about", aboutPage(QApplication::applicationVersion(), options_.libraries));
            book.add("licence", licencePage());
        },
        this);
    manual_dock_ = makeDock("manual", manual_, this);
    manual_dock_->hide();
    tour_ = new TourPanel(this);
    tour_dock_ = makeDock("tour", new UprightScroll(tour_, this), this);
    tour_dock_->hide();
    addDockWidget(Qt::RightDockWidgetArea, manual_dock_);
    addDockWidget(Qt::LeftDockWidgetArea, tour_dock_);
    connect(tour_, &TourPanel::ended, this, [this] {
        tour_dock_->hide();
        if (options_.remember) QSettings().setValue(tour_setting, true);
    });
    connect(fan_, &FanView::designated, tour_, [this] { tour_->did(TourPanel::Designate); });
    connect(marks_, &MarkModel::changed, tour_, [this] {
        if (marks_->rowCount() > 0) tour_->did(TourPanel::Mark);
    });
    connect(&bridge_, &PipelineBridge::paramsChanged, tour_, [this] { tour_->did(TourPanel::Change); });
}

void MainWindow::makeHelpMenu() {
    QMenu& menu = *menuBar()->addMenu(tr("&Help"));
    addAction(menu, tr("&Manual"), QKeySequence("F1"),
              tr("Opens it at what the mouse points at, or at what has the focus"), [this] { helpHere(); });
    addAction(menu, tr("&Keyboard shortcuts"), QKeySequence("?"), tr("All keys on one sheet; Esc puts it away"),
              [this] { shortcuts_->toggle(); });
    addAction(menu, tr("&Tour"), {}, tr("The three steps of the first start, on the demonstration"), [this] {
        openDemonstration();
        showTour();
    });
    addAction(menu, tr("&About"), {}, tr("Versions and licences of Echotrail and its libraries"),
              [this] { showManual("about"); });
}

void MainWindow::helpHere() {
    const QWidget* focus = focusWidget();
    const QWidget* under = QApplication::widgetAt(QCursor::pos());
    const bool here = under && under->window() == this;
    QString page = pageAbout(pointed_ && here ? under : focus);
    if (page.isEmpty() || page == "manual") page = pageAbout(focus);
    if (page == "manual") page = manual_->page();  // it is being read
    if (page.isEmpty()) page = bridge_.isOpen() ? "fan" : "start";
    showManual(page, page == "parameters" ? parameters_->form().selectedName() : QString());
}

void MainWindow::showManual(const QString& page, const QString& words) {
    manual_->show(page, words);
    manual_dock_->show();
    manual_dock_->raise();
}

void MainWindow::showTour() {
    tour_->start();
    tour_dock_->show();
    tour_dock_->raise();
    resizeDocks({tour_dock_}, {18 * fontMetrics().height()}, Qt::Vertical);  // room for the longest step
}

void MainWindow::greet() {
    if (!options_.remember || QSettings().value(tour_setting).toBool()) return;
    openDemonstration();
    showTour();
}

/// Whether F1 means what is under the mouse: it was moved after the focus was set by keys.
void MainWindow::followHand(const QEvent& event) {
    if (event.type() == QEvent::MouseMove || event.type() == QEvent::Wheel) pointed_ = true;
    if (event.type() != QEvent::FocusIn) return;
    const Qt::FocusReason reason = static_cast<const QFocusEvent&>(event).reason();
    const bool by_keys = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
                         reason == Qt::ShortcutFocusReason;
    if (by_keys) pointed_ = false;
}

}  // namespace echotrail
