#include "ui/panels/tracks/tracks_panel.hpp"

#include "ui/language/language.hpp"
#include "ui/panels/tracks/symbol_delegate.hpp"
#include "ui/panels/tracks/target_card.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/track_painter.hpp"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
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
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_->horizontalHeader()->setHighlightSections(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_ = new QScrollArea(this);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(table_, 1);
    column->addLayout(makeButtons());
    column->addWidget(scroll_, 6);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& row) {
        if (following_selection_ || !row.isValid()) return;
        selected_ = model_.idAt(row.row());
        Q_EMIT trackSelected(selected_);
    });
    connect(table_, &QTableView::activated, this, &TracksPanel::designateSelected);
}

QLayout* TracksPanel::makeButtons() {
    designate_ = new QPushButton(this);
    clear_ = new QPushButton(this);
    mute_ = new QPushButton(this);
    mute_->setCheckable(true);
    drop_ = new QPushButton(this);
    name_ = new QLineEdit(this);
    name_->setMaxLength(TrackModel::longest_name);
    inEveryLanguage(this, [this] { nameAll(); });
    for (QWidget* widget : std::initializer_list<QWidget*>{designate_, clear_, mute_, drop_, name_})
        widget->setEnabled(false);
    auto* buttons = new QHBoxLayout;
    const UiMetrics metrics(font());
    buttons->setContentsMargins(metrics.pixels(8.0), metrics.pixels(4.0), metrics.pixels(8.0), 0);
    buttons->setSpacing(metrics.pixels(4.0));
    for (QPushButton* button : {designate_, clear_, mute_, drop_}) buttons->addWidget(button);
    buttons->addWidget(name_, 1);
    connect(designate_, &QPushButton::clicked, this, &TracksPanel::designateSelected);
    connect(clear_, &QPushButton::clicked, this, &TracksPanel::clearRequested);
    connect(mute_, &QPushButton::clicked, this, &TracksPanel::toggleMute);
    connect(drop_, &QPushButton::clicked, this, &TracksPanel::dropSelected);
    connect(name_, &QLineEdit::editingFinished, this, [this] {
        model_.setName(shown_, name_->text());
        Q_EMIT namesChanged(model_.names());
    });
    return buttons;
}

void TracksPanel::nameAll() {
    card_ = new TargetCard;  // it keeps nothing: the next scene fills it
    scroll_->setWidget(card_);
    table_->setAccessibleName(tr("Tracks"));
    designate_->setText(tr("Designate"));
    designate_->setToolTip(tr("Make the selected track the target (Ctrl+Enter); a click on the fan does the same"));
    clear_->setText(tr("Clear"));
    clear_->setToolTip(tr("No target (Delete); all tracks live on"));
    mute_->setText(tr("Mute"));
    mute_->setToolTip(tr("No alerts about the selected track (Ctrl+M)"));
    drop_->setText(tr("Drop"));
    drop_->setToolTip(tr("Take the selected track off fan and list (Shift+Delete); Ctrl+Z brings it back"));
    fitButtons();
    name_->setPlaceholderText(tr("Name"));
    name_->setAccessibleName(tr("Name of the selected track"));
    name_->setToolTip(tr("Your name for the selected track (Ctrl+R), taken by Enter; this console's only"));
    sizeTable();  // by its titles
}

/// No wider than their words, so that there is room for a name.
void TracksPanel::fitButtons() {
    for (QPushButton* button : {designate_, clear_, mute_, drop_})
        button->setFixedWidth(fontMetrics().horizontalAdvance(button->text()) + UiMetrics(font()).pixels(18.0));
}

void TracksPanel::designateSelected() {
    if (designate_->isEnabled()) Q_EMIT designateRequested(shown_range_m_, shown_bearing_);
}

void TracksPanel::toggleMute() {
    if (shown_ == 0) return;
    model_.setMuted(shown_, !model_.isMuted(shown_));
    mute_->setChecked(model_.isMuted(shown_));
    Q_EMIT muteRequested(shown_, model_.isMuted(shown_));
}

void TracksPanel::dropSelected() {
    if (shown_ != 0) Q_EMIT dropRequested(shown_, shown_range_m_, shown_bearing_);
}

void TracksPanel::editName() {
    if (!name_->isEnabled()) return;
    name_->setFocus(Qt::ShortcutFocusReason);
    name_->selectAll();
}

void TracksPanel::startAnew() {
    samples_.clear();
    model_.forgetTracks();
    Q_EMIT namesChanged({});
    selected_ = 0;
    card_->showNothing();
    showButtons({}, nullptr);
}

void TracksPanel::sizeTable() {
    const UiMetrics metrics(font());
    const QFontMetrics text(font());
    table_->verticalHeader()->setDefaultSectionSize(metrics.pixels(24.0));
    table_->verticalHeader()->setMinimumSectionSize(metrics.pixels(20.0));
    table_->setMinimumHeight(metrics.pixels(24.0 * 4.5));  // the card below is tall
    QHeaderView& head = *table_->horizontalHeader();
    head.setMinimumSectionSize(metrics.pixels(24.0));
    for (int column = 0; column < TrackModel::ColumnCount; ++column)
        head.setSectionResizeMode(column, QHeaderView::Fixed);
    const int pad = metrics.pixels(7.0);
    head.resizeSection(TrackModel::Symbol, metrics.pixels(28.0));
    head.resizeSection(TrackModel::Id, text.horizontalAdvance("T000") + pad);
    for (const int column : {TrackModel::Range, TrackModel::BearingFromBow, TrackModel::Speed, TrackModel::Course,
                             TrackModel::Age, TrackModel::Quality}) {
        const QString title = model_.headerData(column, Qt::Horizontal).toString();
        head.resizeSection(column, std::max(text.horizontalAdvance(title), text.horizontalAdvance("000.0")) + pad);
    }
    // Room for every figure and for the longest word of a state.
    int width = text.horizontalAdvance(stateWord(TrackState::Confirmed)) + pad +
                style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, table_);
    for (int column = 0; column < TrackModel::ColumnCount; ++column)
        if (column != TrackModel::State) width += head.sectionSize(column);
    table_->setMinimumWidth(width);
    head.setSectionResizeMode(TrackModel::State, QHeaderView::Stretch);
}

void TracksPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        sizeTable();
        fitButtons();
    }
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
    samples_.add(scene);
    const Track* track = shownTrack(scene);
    following_selection_ = true;
    const int row = track ? model_.rowOf(track->id) : -1;
    if (row < 0)
        table_->clearSelection();
    else if (table_->currentIndex().row() != row || !table_->selectionModel()->isRowSelected(row))
        table_->selectRow(row);
    following_selection_ = false;
    showButtons(scene, track);
    if (!track) return card_->showNothing();
    shown_range_m_ = rangeOf(*track, scene.latest.pose);
    shown_bearing_ = bearingOf(*track, scene.latest.pose);
    card_->showTrack(*track, scene, samples_.of(track->id), params_, model_.names());
}

void TracksPanel::showButtons(const Scene& scene, const Track* track) {
    const int id = track ? track->id : 0;
    if (id != shown_) {  // what is being typed is of the track it was begun for
        name_->clearFocus();
        name_->setText(model_.name(id));
    }
    shown_ = id;
    designate_->setEnabled(track && !track->target);
    clear_->setEnabled(std::any_of(scene.tracks.begin(), scene.tracks.end(), [](const Track& t) { return t.target; }));
    mute_->setEnabled(track);
    drop_->setEnabled(track);
    mute_->setChecked(model_.isMuted(id));
    name_->setEnabled(track);
}

void TracksPanel::selectTrack(int id) { selected_ = id; }

}  // namespace echotrail
