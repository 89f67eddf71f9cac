#include "ui/main_window/status_bar.hpp"

#include "ui/alerts/alert_centre.hpp"
#include "ui/main_window/status_chip.hpp"
#include "ui/models/track_model.hpp"
#include "ui/panels/transport/transport_panel.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <numeric>

namespace echotrail {
namespace {

using Health = StatusChip::Health;

constexpr int word_lines = 5;  ///< width of the word REPLAY, in lines of text

}  // namespace

StatusBar::StatusBar(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->setSpacing(0);
    row->addSpacing(0);
    file_ = addChip(*row);
    position_ = addChip(*row);
    speed_ = addChip(*row);
    tracker_ = addChip(*row);
    control_ = addChip(*row);
    link_ = addChip(*row);
    sonar_ = addChip(*row);
    heading_ = addChip(*row);
    recording_ = addChip(*row);
    pings_ = addChip(*row);
    track_ = addChip(*row);
    alerts_ = addChip(*row);
    row->addStretch(1);
    utc_ = addChip(*row);
    theme_ = new QToolButton(this);
    theme_->setAutoRaise(true);
    theme_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    row->addWidget(theme_);
    connect(file_, &QAbstractButton::clicked, this, &StatusBar::openClicked);
    for (StatusChip* chip : {position_, speed_, pings_, utc_})
        connect(chip, &QAbstractButton::clicked, this, &StatusBar::timeLineClicked);
    for (StatusChip* chip : {link_, sonar_, heading_, recording_})
        connect(chip, &QAbstractButton::clicked, this, &StatusBar::connectionClicked);
    connect(track_, &QAbstractButton::clicked, this, &StatusBar::tracksClicked);
    connect(alerts_, &QAbstractButton::clicked, this, &StatusBar::alertsClicked);
    connect(theme_, &QToolButton::clicked, this, &StatusBar::themeClicked);
    nameChips();
    showAlerts({}, true);
    showNothing();
}

/// A tool bar takes the hint for the least: a window must not be wider for the details of the chips.
QSize StatusBar::sizeHint() const { return {layout()->minimumSize().width(), QWidget::sizeHint().height()}; }

bool StatusBar::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) fitDetails();
    return QWidget::event(event);
}

/// The room beyond what every chip needs goes to the details one after the other, the most telling first: shared out
/// among all of them, it would do for none.
void StatusBar::fitDetails() {
    int room = width() - layout()->minimumSize().width();
    for (StatusChip* chip : {alerts_, track_, tracker_, sonar_, heading_, recording_, link_, control_, position_,
                             speed_, pings_, file_, utc_})
        if (chip->isVisibleTo(this)) room -= chip->giveRoom(room);
}

void StatusBar::nameChips() {
    file_->setLabel(tr("FILE"));
    position_->setLabel(tr("POSITION"));
    speed_->setLabel(tr("SPEED"));
    tracker_->setLabel(tr("TRACKER"));
    control_->setLabel(tr("CONTROL"));
    link_->setLabel(tr("LINK"));
    sonar_->setLabel(tr("SONAR"));
    heading_->setLabel(tr("HDG"));
    recording_->setLabel(tr("REC"));
    pings_->setLabel(tr("PINGS"));
    track_->setLabel(tr("TRACK"));
    alerts_->setLabel(tr("ALERTS"));
    utc_->setLabel(tr("UTC"));
    theme_->setToolTip(tr("Day, dusk or night (F5)"));
    update();
}

StatusChip* StatusBar::addChip(QHBoxLayout& row) {
    auto* chip = new StatusChip(this);
    row.addWidget(chip);
    return chip;
}

void StatusBar::showNothing() {
    setMode(Mode::Nothing);
    for (StatusChip* chip : {file_, position_, speed_, pings_, track_}) chip->show(Health::Absent, {});
    utc_->show(Health::Plain, {});
}

void StatusBar::setMode(Mode mode) {
    mode_ = mode;
    layout()->setContentsMargins(mode == Mode::Replay ? word_lines * fontMetrics().height() : 0, 0, 0, 0);
    for (StatusChip* chip : {file_, position_, speed_}) chip->setVisible(mode != Mode::Live);
    for (StatusChip* chip : {link_, sonar_, heading_, recording_}) chip->setVisible(mode == Mode::Live);
    for (StatusChip* chip : {tracker_, control_}) chip->setVisible(false);  // until the state says that there is one
    // The bar is tinted then: what is dim elsewhere could not be read on it.
    for (StatusChip* chip : findChildren<StatusChip*>()) chip->setOnBright(mode == Mode::Replay);
    rate_since_.reset();
    update();
}

void StatusBar::showSource(const SourceInfo& info) {
    setMode(Mode::Replay);
    file_->show(Health::Plain, QString::fromStdString(info.name),
                info.format.empty() ? tr("read only") : tr("%1 · read only").arg(QString::fromStdString(info.format)));
    QStringList notes{QString::fromStdString(info.head)};
    for (const std::string& note : info.notes) notes << QString::fromStdString(note);
    file_->setToolTip(notes.join('\n'));
    track_->show(Health::Absent, {});
    utc_->show(Health::Plain, {});
}

void StatusBar::showStatus(const ReplayStatus& status) {
    if (mode_ != Mode::Replay) return;
    QString state;
    switch (status.state) {
        case ReplayState::Loading:
            state = tr("reading");
            break;
        case ReplayState::Paused:
            state = tr("paused");
            break;
        case ReplayState::Playing:
            state = tr("playing");
            break;
        case ReplayState::Ended:
            state = tr("at the end");
            break;
        case ReplayState::Failed:
            state = tr("stopped");
            break;
    }
    speed_->show(status.state == ReplayState::Failed ? Health::Degraded : Health::Plain, speedText(status.speed),
                 state);
    position_->show(Health::Plain, tr("ping %1").arg(Formatter::count(status.position)),
                    tr("of %1").arg(Formatter::count(status.total)));
}

void StatusBar::showCounts(const SourceCounts& counts) {
    const auto rejected = std::accumulate(counts.rejected.begin(), counts.rejected.end(), std::uint64_t{0},
                                          [](std::uint64_t sum, const auto& cause) { return sum + cause.second; });
    QStringList causes;
    for (const auto& [cause, count] : counts.rejected)
        causes << QString::fromStdString(cause) + ": " + Formatter::count(count);
    if (counts.lost_records > 0) causes << tr("lost records: %1").arg(Formatter::count(counts.lost_records));
    if (counts.skipped_bytes > 0)
        causes << tr("bytes outside any frame: %1").arg(Formatter::count(counts.skipped_bytes));
    pings_->setToolTip(causes.isEmpty() ? mode_ == Mode::Live ? tr("Everything that came could be read")
                                                              : tr("Every record of the file was read")
                                        : causes.join('\n'));
    const bool clean = rejected == 0 && counts.lost_records == 0;
    pings_->show(clean ? Health::Good : Health::Degraded, tr("%1 rejected").arg(Formatter::count(rejected)),
                 counts.lost_records > 0 ? tr("%1 lost").arg(Formatter::count(counts.lost_records)) : QString());
}

void StatusBar::showTrack(const Scene& scene) {
    const Track* target = nullptr;
    std::size_t confirmed = 0;
    for (const Track& track : scene.tracks) {
        if (track.target) target = &track;
        if (track.state == TrackState::Confirmed || track.state == TrackState::Coasting) ++confirmed;
    }
    if (target) {
        const bool fine = target->state == TrackState::Confirmed;
        const double age = secondsBetween(target->last_seen, scene.latest.time);
        track_->show(fine ? Health::Good : Health::Degraded, Formatter::trackLabel(target->id, names_),
                     stateWord(target->state) + tr(" · seen %1 ago").arg(Formatter::age(age)));
    } else {
        track_->show(confirmed > 0 ? Health::Good : Health::Absent,
                     confirmed > 0 ? Formatter::count(confirmed) : QString(),
                     confirmed > 0 ? tr("confirmed, no target") : tr("none confirmed"));
    }
}

void StatusBar::showScene(const Scene& scene) {
    showCounts(scene.counts);
    if (scene.position == 0) {
        utc_->show(Health::Plain, {});
        return;
    }
    utc_->show(Health::Plain, Formatter::utc(scene.latest.time));
    showTrack(scene);
}

void StatusBar::showAlerts(const AlertSummary& alerts, bool lit) {
    QStringList counts;
    const auto count = [&counts](int number, const QString& one, const QString& several) {
        if (number > 0) counts << (number == 1 ? one : several.arg(number));
    };
    count(alerts.alarms, tr("1 alarm"), tr("%1 alarms"));
    count(alerts.warnings, tr("1 warning"), tr("%1 warnings"));
    count(alerts.cautions, tr("1 caution"), tr("%1 cautions"));
    const Health asking = alerts.new_alarm ? Health::Alarm : Health::Degraded;
    const bool asks = alerts.new_alarm || alerts.new_warning;
    const Health standing = counts.isEmpty() ? Health::Good : Health::Degraded;
    alerts_->show(asks && (lit || !alerts.new_alarm) ? asking : standing,
                  counts.isEmpty() ? tr("none") : counts.front(), counts.mid(1).join("  "));
    alerts_->setToolTip(asks ? tr("%1 (A acknowledges)").arg(alerts.title) : tr("Shows the list of alerts"));
}

void StatusBar::showTheme(const QString& name) { theme_->setText(QStringLiteral("◐ ") + name); }

void StatusBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& colours = currentPalette();
    painter.fillRect(rect(), colours.raised);
    const int edge = std::max(1, fontMetrics().height() / 8);
    if (mode_ != Mode::Replay) {
        painter.fillRect(QRect(0, height() - 1, width(), 1), colours.line);
        return;
    }
    QColor tint = colours.warning;
    tint.setAlphaF(0.18F);
    painter.fillRect(rect(), tint);
    painter.fillRect(QRect(0, height() - edge, width(), edge), colours.warning);
    const QRect word(0, 0, word_lines * fontMetrics().height(), height());
    painter.fillRect(word, colours.warning);
    QFont strong = font();
    strong.setWeight(QFont::Bold);
    strong.setLetterSpacing(QFont::AbsoluteSpacing, 1.0);
    painter.setFont(strong);
    painter.setPen(colours.panel);
    painter.drawText(word, Qt::AlignCenter, tr("REPLAY"));
}

}  // namespace echotrail
