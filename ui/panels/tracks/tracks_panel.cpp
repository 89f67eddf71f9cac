#include "ui/panels/tracks/tracks_panel.hpp"

#include "ui/panels/tracks/symbol_delegate.hpp"
#include "ui/panels/tracks/target_card.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/track_painter.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

namespace echotrail {

TracksPanel::TracksPanel(QWidget* parent) : QWidget(parent) {
    table_ = new QTableView(this);
    table_->setModel(&model_);
    table_->setItemDelegateForColumn(TrackModel::Symbol, new SymbolDelegate(table_));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setAccessibleName(tr("Tracks"));
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    card_ = new TargetCard(this);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(card_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    designate_ = new QPushButton(tr("Designate"), this);
    designate_->setToolTip(tr("Make the selected track the target; a click on the fan does the same"));
    clear_ = new QPushButton(tr("Clear designation"), this);
    clear_->setToolTip(tr("No target (Delete); all tracks live on"));
    for (QPushButton* button : {designate_, clear_}) button->setEnabled(false);
    auto* buttons = new QHBoxLayout;
    const UiMetrics metrics(font());
    buttons->setContentsMargins(metrics.pixels(8.0), metrics.pixels(4.0), metrics.pixels(8.0), 0);
    buttons->setSpacing(metrics.pixels(4.0));
    buttons->addWidget(designate_);
    buttons->addWidget(clear_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(table_, 2);
    column->addLayout(buttons);
    column->addWidget(scroll, 3);
    sizeTable();
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (following_selection_ || !row.isValid()) return;
        selected_ = model_.idAt(row.row());
        Q_EMIT trackSelected(selected_);
    });
    connect(designate_, &QPushButton::clicked, this,
            [this] { Q_EMIT designateRequested(shown_range_m_, shown_bearing_); });
    connect(clear_, &QPushButton::clicked, this, &TracksPanel::clearRequested);
}

void TracksPanel::sizeTable() {
    const UiMetrics metrics(font());
    const QFontMetrics text(font());
    table_->verticalHeader()->setDefaultSectionSize(metrics.pixels(24.0));
    table_->verticalHeader()->setMinimumSectionSize(metrics.pixels(20.0));
    table_->setMinimumHeight(metrics.pixels(24.0 * 4.0));
    QHeaderView& head = *table_->horizontalHeader();
    head.setMinimumSectionSize(metrics.pixels(24.0));
    for (int column = 0; column < TrackModel::ColumnCount; ++column)
        head.setSectionResizeMode(column, QHeaderView::Fixed);
    const int pad = metrics.pixels(12.0);
    head.resizeSection(TrackModel::Symbol, metrics.pixels(28.0));
    head.resizeSection(TrackModel::Id, text.horizontalAdvance("T000") + pad);
    for (const int column :
         {TrackModel::Range, TrackModel::BearingFromBow, TrackModel::Speed, TrackModel::Age, TrackModel::Quality}) {
        const QString title = model_.headerData(column, Qt::Horizontal).toString();
        head.resizeSection(column, std::max(text.horizontalAdvance(title), text.horizontalAdvance("000.0")) + pad);
    }
    // Room for every figure and for the longest word of a state.
    int width = text.horizontalAdvance(stateWord(TrackState::Confirmed)) + pad;
    for (int column = 0; column < TrackModel::ColumnCount; ++column)
        if (column != TrackModel::State) width += head.sectionSize(column);
    table_->setMinimumWidth(width);
    head.setSectionResizeMode(TrackModel::State, QHeaderView::Stretch);
}

void TracksPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) sizeTable();
    QWidget::changeEvent(event);
}

const Track* TracksPanel::shownTrack(const Scene& scene) const {
    const auto find = [&](auto wanted) {
        const auto found = std::find_if(scene.tracks.begin(), scene.tracks.end(), wanted);
        return found == scene.tracks.end() ? nullptr : &*found;
    };
    if (const Track* chosen = find([this](const Track& track) { return track.id == selected_; })) return chosen;
    // Without a choice or a target, the surest track is the one to be asked about.
    return model_.rowCount() > 0 ? find([this](const Track& track) { return track.id == model_.idAt(0); }) : nullptr;
}

void TracksPanel::setScene(const Scene& scene) {
    model_.setScene(scene);
    const Track* track = shownTrack(scene);
    following_selection_ = true;
    const int row = track ? model_.rowOf(track->id) : -1;
    if (row < 0)
        table_->clearSelection();
    else if (table_->currentIndex().row() != row || !table_->selectionModel()->isRowSelected(row))
        table_->selectRow(row);
    following_selection_ = false;
    designate_->setEnabled(track && !track->target);
    clear_->setEnabled(std::any_of(scene.tracks.begin(), scene.tracks.end(), [](const Track& t) { return t.target; }));
    if (!track) return card_->showNothing();
    shown_range_m_ = rangeOf(*track, scene.latest.pose);
    shown_bearing_ = bearingOf(*track, scene.latest.pose);
    card_->showTrack(*track, scene);
}

void TracksPanel::selectTrack(int id) { selected_ = id; }

}  // namespace echotrail
