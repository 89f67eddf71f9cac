#include "ui/panels/transport/transport_panel.hpp"

#include "ui/language/language.hpp"
#include "ui/panels/transport/moment.hpp"
#include "ui/panels/transport/timeline_view.hpp"
#include "ui/panels/transport/transport_button.hpp"
#include "ui/style/formatter.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

namespace echotrail {

namespace {

constexpr qint64 long_way_ms = 250;
constexpr double shortest_silence_s = 3.0;  ///< as between two pings of a run that lasts (RunTimeline)

}  // namespace

const std::vector<double>& offeredSpeeds() {
    static const std::vector<double> speeds{0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64, ReplayRunner::max_speed};
    return speeds;
}

QString speedText(double factor) {
    return factor == ReplayRunner::max_speed ? TransportPanel::tr("max") : QString::number(factor) + QChar(0x00D7);
}

TransportPanel::TransportPanel(PipelineBridge& bridge, QWidget* parent) : QWidget(parent), bridge_(bridge) {
    timeline_ = new TimelineView(this);
    auto* row = new QHBoxLayout;
    row->addLayout(makeControls());
    row->addLayout(makeReadouts(), 1);
    auto* layout = new QVBoxLayout(this);
    const int gap = fontMetrics().height() / 2;
    layout->setContentsMargins(0, 0, 0, gap);
    layout->setSpacing(gap);
    layout->addWidget(timeline_, 1);
    row->setContentsMargins(gap, 0, gap, 0);
    layout->addLayout(row);

    connect(timeline_, &TimelineView::seekRequested, &bridge_, &PipelineBridge::seekPosition);
    connect(&bridge_, &PipelineBridge::statusChanged, this, &TransportPanel::showStatus);
    connect(&bridge_, &PipelineBridge::timelineChanged, this, [this](const Timeline& timeline) {
        timeline_->setTimeline(timeline);
        if (bridge_.isLive()) timeline_->setPosition(timeline.pings(), timeline.pings());
        showTimes(bridge_.status());
    });
    connect(&bridge_, &PipelineBridge::opened, this, [this] {
        setLoop(std::nullopt);
        timeline_->setLive(bridge_.isLive());
    });
    connect(&bridge_, &PipelineBridge::liveChanged, this, [this](const LiveState& state) {
        const double silence_s = state.ping_age_s.value_or(0.0);
        timeline_->setSilence(silence_s > shortest_silence_s ? silence_s : 0.0);
    });
    connect(&bridge_, &PipelineBridge::closed, this, [this] {
        timeline_->setLive(false);
        timeline_->setTimeline({});
        showStatus({});
    });
    inEveryLanguage(this, [this] { nameAll(); });
}

void TransportPanel::nameAll() {
    speed_->setAccessibleName(tr("Speed"));
    speed_->setToolTip(tr("Seconds of the recording per second (, slower  . faster)"));
    for (int row = 0; row < speed_->count(); ++row)
        speed_->setItemText(row, speedText(speed_->itemData(row).toDouble()));
    loop_button_->setToolTip(tr("Sets A, then B, then ends the loop"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stops where the run has got to"));
    go_to_label_->setText(tr("Go to"));
    go_to_->setPlaceholderText(tr("UTC or 0:00:12.5"));
    go_to_->setMinimumWidth(fontMetrics().horizontalAdvance(go_to_->placeholderText()) + fontMetrics().height());
    go_to_->setAccessibleName(tr("Go to a moment"));
    nameLoop();
    showStatus(bridge_.status());
}

/// By what a press of it does next.
void TransportPanel::nameLoop() {
    loop_button_->setText(loop_ ? tr("End loop") : loop_begin_ ? tr("Loop until here") : tr("Loop from here"));
}

QLayout* TransportPanel::makeControls() {
    auto* row = new QHBoxLayout;
    using Sign = TransportButton::Sign;
    const auto add = [&](Sign sign, const char* name, const QString& keys, auto slot) {
        auto* button = new TransportButton(sign, this);
        inEveryLanguage(button, [button, name, keys] { button->setName(tr(name), keys); });
        connect(button, &QToolButton::clicked, this, slot);
        buttons_.push_back(button);
        row->addWidget(button);
        return button;
    };
    add(Sign::ToStart, QT_TR_NOOP("To the start"), "Home", [this] { bridge_.seekPosition(0); });
    add(Sign::StepBack, QT_TR_NOOP("One ping back"), "Ctrl+Left", [this] { bridge_.stepPings(-1); });
    play_ = add(Sign::Play, QT_TR_NOOP("Play or pause"), "Space", [this] { bridge_.togglePlay(); });
    play_->setMinimumWidth(play_->sizeHint().width() * 3 / 2);
    add(Sign::StepForward, QT_TR_NOOP("One ping on"), "Ctrl+Right", [this] { bridge_.stepPings(1); });
    add(Sign::ToEnd, QT_TR_NOOP("To the end"), "End", [this] { bridge_.seekPosition(bridge_.status().total); });

    speed_ = new QComboBox(this);
    for (const double factor : offeredSpeeds()) speed_->addItem(speedText(factor), factor);
    speed_->setCurrentText(speedText(1.0));
    connect(speed_, &QComboBox::currentIndexChanged, this,
            [this](int row_index) { bridge_.setSpeed(offeredSpeeds()[static_cast<std::size_t>(row_index)]); });
    row->addWidget(speed_);
    loop_button_ = new QPushButton(this);
    connect(loop_button_, &QPushButton::clicked, this, &TransportPanel::loopHere);
    row->addWidget(loop_button_);
    return row;
}

QLayout* TransportPanel::makeReadouts() {
    auto* row = new QHBoxLayout;
    utc_ = new QLabel(this);
    utc_->setObjectName("clock");
    elapsed_ = new QLabel(this);
    elapsed_->setObjectName("dim");
    busy_ = new QLabel(this);
    busy_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what it says must not widen the window
    cancel_ = new QPushButton(this);
    connect(cancel_, &QPushButton::clicked, &bridge_, &PipelineBridge::cancelSeek);
    go_to_label_ = new QLabel(this);
    go_to_label_->setObjectName("dim");
    go_to_ = new QLineEdit(this);
    go_to_->setMaximumWidth(fontMetrics().averageCharWidth() * 26);
    connect(go_to_, &QLineEdit::returnPressed, this, &TransportPanel::goToTyped);
    row->addSpacing(fontMetrics().height() / 2);
    row->addWidget(utc_);
    row->addWidget(elapsed_);
    row->addSpacing(fontMetrics().height() / 2);
    row->addWidget(busy_, 1);
    row->addWidget(cancel_);
    row->addWidget(go_to_label_);
    row->addWidget(go_to_);
    return row;
}

void TransportPanel::showStatus(const ReplayStatus& status) {
    const bool open = bridge_.isOpen() && status.total > 0 && status.state != ReplayState::Failed;
    for (TransportButton* button : buttons_) button->setEnabled(open);
    loop_button_->setEnabled(open);
    go_to_->setEnabled(open);
    const bool playing = status.state == ReplayState::Playing;
    play_->setSign(playing ? TransportButton::Sign::Pause : TransportButton::Sign::Play);
    if (!bridge_.isLive()) timeline_->setPosition(status.position, status.goal);
    // A step is over before it could be read: only a long way is spoken of.
    const bool on_the_way = open && status.goal != status.position;
    if (!on_the_way)
        travelling_.invalidate();
    else if (!travelling_.isValid())
        travelling_.start();
    const bool travelling = on_the_way && travelling_.elapsed() > long_way_ms;
    if (travelling)
        busy_->setText(
            tr("re-running: ping %1 of %2").arg(Formatter::count(status.position), Formatter::count(status.goal)));
    else if (open && status.analysing)
        busy_->setText(tr("working out the time line"));
    else if (open && status.state == ReplayState::Loading)
        busy_->setText(tr("reading: %1 pings").arg(Formatter::count(status.total)));
    else if (bridge_.isLive())
        busy_->setText(tr("live; it can be replayed afterwards"));
    else if (status.state == ReplayState::Ended)
        busy_->setText(tr("at the end; Space plays it again"));
    else
        busy_->clear();
    cancel_->setVisible(travelling);
    showTimes(status);
}

void TransportPanel::showTimes(const ReplayStatus& status) {
    const Timeline& timeline = bridge_.timeline();
    if (timeline.pings() == 0) {
        utc_->setText(Formatter::unknown());
        elapsed_->clear();
        return;
    }
    const auto& times = *timeline.ping_times;
    const double length = secondsBetween(times.front(), times.back());
    const std::uint64_t position = bridge_.isLive() ? timeline.pings() : status.position;
    const bool before = position == 0;
    const Timestamp now = times[std::min<std::uint64_t>(std::max<std::uint64_t>(position, 1), times.size()) - 1];
    utc_->setText(before ? Formatter::unknown() : Formatter::utc(now));
    if (bridge_.isLive()) return elapsed_->setText(elapsedText(length));
    elapsed_->setText(
        tr("%1 of %2")
            .arg(before ? Formatter::unknown() : elapsedText(secondsBetween(times.front(), now)), elapsedText(length)));
}

void TransportPanel::goToTyped() {
    const Timeline& timeline = bridge_.timeline();
    if (timeline.pings() == 0) return;
    const auto& times = *timeline.ping_times;
    const auto moment = momentFromText(go_to_->text(), times.front());
    if (!moment || *moment < times.front() || *moment > times.back() + std::chrono::seconds(1)) {
        Q_EMIT message(tr("“%1” is not in this recording. Type seconds from its start, as 0:00:12.5, or a UTC time "
                          "from %2 to %3.")
                           .arg(go_to_->text(), Formatter::utc(times.front()), Formatter::utc(times.back())),
                       false);
        go_to_->selectAll();
        return;
    }
    bridge_.seekSeconds(secondsBetween(times.front(), *moment));
}

void TransportPanel::changeSpeed(int steps) {
    speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + steps, 0, speed_->count() - 1));
}

void TransportPanel::loopHere() {
    const std::uint64_t here = bridge_.status().goal;
    if (loop_) return setLoop(std::nullopt);
    if (!loop_begin_) {
        loop_begin_ = here;
        return nameLoop();
    }
    setLoop(PingSpan{std::min(*loop_begin_, here), std::max(*loop_begin_ + 1, here)});
}

void TransportPanel::setLoop(std::optional<PingSpan> loop) {
    loop_ = loop;
    loop_begin_.reset();
    nameLoop();
    timeline_->setLoop(loop);
    bridge_.setLoop(loop);
}

}  // namespace echotrail
