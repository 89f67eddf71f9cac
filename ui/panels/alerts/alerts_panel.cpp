#include "ui/panels/alerts/alerts_panel.hpp"

#include "ui/alerts/alert_centre.hpp"
#include "ui/language/language.hpp"
#include "ui/panels/alerts/alert_delegate.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

namespace echotrail {

AlertsPanel::AlertsPanel(AlertCentre& centre, QWidget* parent) : QWidget(parent), centre_(centre) {
    list_ = new QListView(this);
    list_->setModel(&centre_.model());
    list_->setItemDelegate(new AlertDelegate(centre_, list_));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setUniformItemSizes(true);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    empty_ = new QLabel(this);
    empty_->setObjectName("dim");
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    const UiMetrics metrics(font());
    empty_->setMargin(metrics.pixels(8.0));
    acknowledge_ = new QPushButton(this);
    silence_ = new QPushButton(this);
    auto* buttons = new QHBoxLayout;
    buttons->setContentsMargins(metrics.pixels(8.0), metrics.pixels(4.0), metrics.pixels(8.0), metrics.pixels(4.0));
    buttons->setSpacing(metrics.pixels(4.0));
    buttons->addWidget(acknowledge_);
    buttons->addWidget(silence_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(list_, 1);
    column->addWidget(empty_, 1);
    column->addLayout(buttons);
    connect(acknowledge_, &QPushButton::clicked, &centre_, &AlertCentre::acknowledgeMostUrgent);
    connect(silence_, &QPushButton::clicked, &centre_, &AlertCentre::silence);
    connect(list_, &QListView::activated, &centre_,
            [this](const QModelIndex& row) { centre_.acknowledge(row.data(AlertModel::IdRole).toInt()); });
    connect(&centre_, &AlertCentre::changed, this, &AlertsPanel::showSummary);
    connect(&centre_, &AlertCentre::flashed, list_->viewport(), qOverload<>(&QWidget::update));
    inEveryLanguage(this, [this] { nameAll(); });
}

void AlertsPanel::nameAll() {
    list_->setAccessibleName(tr("Alerts"));
    empty_->setText(tr("No alerts. Lost targets, broken links, missing headings and a full disk are listed here."));
    acknowledge_->setText(tr("Acknowledge"));
    acknowledge_->setToolTip(tr("The alert at the top of the list (A); Enter: the selected one"));
    silence_->setToolTip(tr("No sound for %1 s, unless something new is raised (Shift+A)").arg(AlertSound::silence_s));
    showSummary();
}

void AlertsPanel::showSummary() {
    const AlertSummary summary = centre_.summary();
    const bool any = centre_.model().rowCount() > 0;
    list_->setVisible(any);
    empty_->setVisible(!any);
    const bool asks = !summary.title.isEmpty();
    const double silent = centre_.silentFor();
    acknowledge_->setEnabled(asks);
    silence_->setEnabled(asks && silent <= 0.0);
    silence_->setText(silent > 0.0 ? tr("Silent for %1 s").arg(std::ceil(silent))
                                   : tr("Silence %1 s").arg(AlertSound::silence_s));
    const int open = summary.alarms + summary.warnings + summary.cautions;
    Q_EMIT summaryChanged(any ? tr("%1 open · %2 in 10 min").arg(open).arg(summary.recent) : tr("none"));
}

}  // namespace echotrail
