#include "ui/panels/recordings/recordings_window.hpp"

#include "ui/language/language.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/label_role.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace echotrail {
namespace {

constexpr int look_ms = 5'000;  // recordings grow, and new ones come

constexpr int minutes_end = 16;  // of "2026-03-01T14:03:13.000Z"

enum Column { NameColumn, SizeColumn, TimeColumn, ColumnCount };

QLabel* wrapped(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName("dim");
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

RecordingsWindow::RecordingsWindow(PipelineBridge& bridge, QWidget* parent) : QDialog(parent), bridge_(bridge) {
    const UiMetrics metrics(font());
    resize(metrics.pixels(640.0), metrics.pixels(400.0));
    note_ = wrapped(this);
    list_ = new QTreeWidget(this);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setColumnCount(ColumnCount);
    list_->setTextElideMode(Qt::ElideMiddle);  // names differ at both ends
    QHeaderView& header = *list_->header();
    header.setStretchLastSection(false);
    header.setSectionResizeMode(QHeaderView::ResizeToContents);
    header.setSectionResizeMode(NameColumn, QHeaderView::Stretch);  // a long one leaves the others in sight
    list_->headerItem()->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
    told_ = wrapped(this);
    bar_ = new QProgressBar(this);
    bar_->setTextVisible(false);
    fetch_ = new QPushButton(this);
    cancel_ = new QPushButton(this);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(fetch_);
    buttons->addWidget(cancel_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(metrics.pixels(6.0));
    column->addWidget(note_);
    column->addWidget(list_, 1);
    column->addWidget(told_);
    column->addWidget(bar_);
    column->addLayout(buttons);
    look_.setInterval(look_ms);
    connect(&look_, &QTimer::timeout, &bridge_, &PipelineBridge::listRecordings);
    connect(&bridge_, &PipelineBridge::liveChanged, this, &RecordingsWindow::showState);
    connect(&bridge_, &PipelineBridge::closed, this, [this] { showState({}); });
    connect(list_, &QTreeWidget::itemSelectionChanged, this, [this] { showState(bridge_.liveState()); });
    connect(list_, &QTreeWidget::itemActivated, this, [this] { fetch_->click(); });
    connect(fetch_, &QPushButton::clicked, this, [this] { bridge_.fetchRecording(chosen()); });
    connect(cancel_, &QPushButton::clicked, &bridge_, &PipelineBridge::cancelFetch);
    inEveryLanguage(this, [this] { nameAll(); });
}

void RecordingsWindow::nameAll() {
    setWindowTitle(tr("Recordings aboard"));
    note_->setText(
        tr("Tracks, picture and health go first; a fetch takes what the link has left, and goes on by itself after a "
           "break. A recording that is being written is fetched as far as it is now."));
    list_->setHeaderLabels({tr("Recording"), tr("Size"), tr("Last written (UTC)")});
    list_->setAccessibleName(tr("Recordings aboard"));
    fetch_->setText(tr("Fetch"));
    fetch_->setToolTip(tr("The selected recording, whole, into this computer's folder of recordings"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("What has come stays; Fetch goes on with it"));
    shown_.clear();  // so that the list is told anew
    showState(bridge_.liveState());
}

void RecordingsWindow::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    bridge_.listRecordings();
    look_.start();
}

void RecordingsWindow::hideEvent(QHideEvent* event) {
    QDialog::hideEvent(event);
    look_.stop();
}

QString RecordingsWindow::chosen() const {
    const QTreeWidgetItem* item = list_->currentItem();
    return item && item->isSelected() ? item->data(NameColumn, Qt::UserRole).toString() : QString();
}

void RecordingsWindow::showState(const LiveState& state) {
    const auto& tracker = state.tracker;
    if (tracker) showList(tracker->recordings);
    const bool joined = tracker && tracker->link.up;
    showFetch(tracker ? tracker->fetched : std::nullopt);
    if (!tracker)
        told_->setText(tr("No tracker is followed; Sonar → Connect to tracker…"));
    else if (!joined)
        told_->setText(tr("No link to the tracker; it goes on by itself when the link is back."));
    else if (!tracker->recordings_error.isEmpty())
        told_->setText(tr("The list did not come: %1").arg(tracker->recordings_error));
    else if (tracker->recordings.isEmpty() && !tracker->fetched)
        told_->setText(tr("None has been listed so far."));
    const bool failed =
        joined && (!tracker->recordings_error.isEmpty() || (tracker->fetched && !tracker->fetched->error.isEmpty()));
    setLabelRole(*told_, failed ? "refusal" : "dim");
    fetch_->setEnabled(joined && !chosen().isEmpty());
}

void RecordingsWindow::showList(const QList<RecordingAboard>& recordings) {
    if (recordings == shown_) return;
    shown_ = recordings;
    const QString before = chosen();
    list_->clear();
    for (const RecordingAboard& each : recordings) {
        const QString time = Formatter::utc(each.changed).left(minutes_end).replace('T', ' ');
        auto* item = new QTreeWidgetItem(
            list_, {each.name, Formatter::bytes(each.bytes), each.written ? tr("being written") : time});
        item->setData(NameColumn, Qt::UserRole, each.name);
        item->setToolTip(NameColumn, each.name);
        item->setTextAlignment(SizeColumn, Qt::AlignRight | Qt::AlignVCenter);
        item->setSizeHint(NameColumn, {0, UiMetrics(font()).pixels(24.0)});  // as high as rows of tracks
        if (each.name == before) list_->setCurrentItem(item);
    }
}

void RecordingsWindow::showFetch(const std::optional<RecordingCopy>& fetched) {
    const bool under_way = fetched && !fetched->whole && fetched->error.isEmpty();
    bar_->setVisible(under_way);
    cancel_->setEnabled(under_way);
    if (!fetched) return told_->clear();
    if (!fetched->error.isEmpty()) return told_->setText(tr("Not fetched: %1").arg(fetched->error));
    if (fetched->whole) return told_->setText(tr("Whole: %1").arg(fetched->path));
    constexpr int steps = 1'000;
    bar_->setRange(0, steps);
    const double share = static_cast<double>(fetched->rows) / static_cast<double>(std::max<qint64>(fetched->there, 1));
    bar_->setValue(static_cast<int>(steps * share));
    told_->setText(tr("%1: %2 %, %3 of %4 rows, %5 came")
                       .arg(fetched->name, Formatter::number(100.0 * share, 0),
                            Formatter::count(static_cast<std::uint64_t>(fetched->rows)),
                            Formatter::count(static_cast<std::uint64_t>(fetched->there)),
                            Formatter::bytes(fetched->bytes)));
}

QString RecordingsWindow::progress() const { return told_->text(); }

}  // namespace echotrail
