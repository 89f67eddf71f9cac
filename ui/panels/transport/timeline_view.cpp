#include "ui/panels/transport/timeline_view.hpp"

#include "ui/language/language.hpp"
#include "ui/panels/transport/moment.hpp"
#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

namespace echotrail {
namespace {

constexpr int sweeps_lane = 0;
constexpr int tracked_lane = 1;
constexpr int lane_count = 2;

constexpr double lane_lines = 1.5;  ///< heights in lines of text
constexpr double head_lines = 0.9;  ///< above the lanes: the playhead's handle and the loop
constexpr double axis_lines = 1.4;

}  // namespace

double timeAxisStep(double length_s, double ticks) {
    static constexpr std::array steps{0.1,   0.2,   0.5,   1.0,   2.0,    5.0,    10.0,   15.0,    30.0,    60.0,
                                      120.0, 300.0, 600.0, 900.0, 1800.0, 3600.0, 7200.0, 21600.0, 43200.0, 86400.0};
    for (const double step : steps)
        if (step * ticks >= length_s) return step;
    return 86400.0 * std::ceil(length_s / ticks / 86400.0);
}

TimelineView::TimelineView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    inEveryLanguage(this, [this] {
        setAccessibleName(tr("Time line"));
        setAccessibleDescription(tr("Click or drag to go to a moment of the recording"));
    });
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::PointingHandCursor);
}

void TimelineView::setTimeline(const Timeline& timeline) {
    timeline_ = timeline;
    lanes_ = {};
    update();
}

void TimelineView::setPosition(std::uint64_t position, std::uint64_t goal) {
    if (position == position_ && goal == goal_) return;
    position_ = position;
    goal_ = goal;
    update();
}

void TimelineView::setLoop(std::optional<PingSpan> loop) {
    loop_ = loop;
    update();
}

void TimelineView::setLive(bool live) {
    if (live == live_) return;
    live_ = live;
    silence_s_ = 0.0;
    setCursor(live ? Qt::ArrowCursor : Qt::PointingHandCursor);
    lanes_ = {};
    update();
}

void TimelineView::setSilence(double seconds) {
    if (seconds == silence_s_) return;
    silence_s_ = seconds;
    lanes_ = {};
    update();
}

QSize TimelineView::sizeHint() const {
    const double lines = head_lines + lane_count * lane_lines + axis_lines;
    return {fontMetrics().averageCharWidth() * 60, static_cast<int>(lines * fontMetrics().height())};
}

QSize TimelineView::minimumSizeHint() const { return {fontMetrics().averageCharWidth() * 30, sizeHint().height()}; }

QRectF TimelineView::lane(int number) const {
    const double line = fontMetrics().height();
    const double left = fontMetrics().horizontalAdvance(tr("Tracked")) + 1.4 * line;
    const double height = lane_lines * line;
    return {left, head_lines * line + number * height, std::max(1.0, width() - left - 0.8 * line), height - 2.0};
}

double TimelineView::lengthSeconds() const {
    return ready() ? secondsBetween(timeline_.ping_times->front(), timeline_.ping_times->back()) + silence_s_ : 0.0;
}

double TimelineView::xOfTime(Timestamp time) const {
    const QRectF area = lane(0);
    const double length = lengthSeconds();
    if (!(length > 0.0)) return area.left();
    return area.left() + area.width() * secondsBetween(timeline_.ping_times->front(), time) / length;
}

double TimelineView::xOf(std::uint64_t position) const {
    if (!ready() || position == 0) return lane(0).left();
    return xOfTime((*timeline_.ping_times)[std::min(position, timeline_.pings()) - 1]);
}

std::uint64_t TimelineView::positionAt(double x) const {
    if (!ready()) return 0;
    const QRectF area = lane(0);
    const double part = std::clamp((x - area.left()) / area.width(), 0.0, 1.0);
    const auto& times = *timeline_.ping_times;
    // The end itself must be reachable although the product below may round to just before it.
    if (part >= 1.0) return timeline_.pings();
    return std::max<std::uint64_t>(
        1, timeline_.positionAt(times.front() + microsecondsFromSeconds(part * lengthSeconds())));
}

QRectF TimelineView::spanRect(const PingSpan& span, int number) const {
    const QRectF area = lane(number);
    const double left = xOf(span.begin + 1);
    const double right = std::max(left + 1.0, xOf(span.end));
    return {left, area.top(), right - left, area.height()};
}

void TimelineView::paintSweeps(QPainter& painter) const {
    const QRectF area = lane(sweeps_lane);
    painter.setPen(QPen(currentPalette().dim, 1.0));
    double last = -10.0;
    for (const std::uint64_t start : timeline_.sweep_starts) {
        const double x = std::round(xOf(start + 1)) + 0.5;
        if (x - last < 3.0) continue;  // a grey block would say nothing
        last = x;
        painter.drawLine(QPointF(x, area.center().y()), QPointF(x, area.bottom()));
    }
}

void TimelineView::paintTracked(QPainter& painter) const {
    const QRectF area = lane(tracked_lane);
    for (const PingSpan& span : timeline_.confirmed) {
        const QRectF bar = spanRect(span, tracked_lane).adjusted(0, area.height() * 0.25, 0, -area.height() * 0.25);
        painter.fillRect(bar, currentPalette().accent);
    }
    if (timeline_.analysed >= timeline_.pings()) return;
    painter.setPen(currentPalette().dim);
    const QString note = tr("not worked out yet: pause and it will be");
    if (timeline_.analysed == 0) painter.drawText(area, Qt::AlignCenter, note);
}

void TimelineView::paintGaps(QPainter& painter) const {
    const auto paint = [&](double left, double right) {
        const QRectF bar(left, lane(0).top(), std::max(3.0, right - left),
                         lane(lane_count - 1).bottom() - lane(0).top());
        painter.fillRect(bar, currentPalette().field);
        painter.fillRect(bar, QBrush(currentPalette().warning, Qt::BDiagPattern));
        painter.setPen(QPen(currentPalette().warning, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar.adjusted(0.5, 0.5, -0.5, -0.5));
    };
    for (const PingSpan& gap : timeline_.gaps) paint(xOf(gap.begin + 1), xOf(gap.end + 1));
    if (silence_s_ > 0.0) paint(xOfTime(timeline_.ping_times->back()), lane(0).right());
}

/// Not seen here, but kept: framed, where a gap is hatched.
void TimelineView::paintRecalled(QPainter& painter) const {
    for (const PingSpan& span : timeline_.recalled) {
        const double left = xOf(span.begin + 1);
        const QRectF bar(left, lane(0).top(), std::max(3.0, xOf(span.end + 1) - left), lane(0).height());
        painter.setPen(QPen(currentPalette().dim, 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(bar.adjusted(0.5, 0.5, -0.5, -0.5));
        const QString note = tr("fetched");
        painter.setPen(currentPalette().dim);
        if (bar.width() > 1.3 * fontMetrics().horizontalAdvance(note)) painter.drawText(bar, Qt::AlignCenter, note);
    }
}

void TimelineView::paintAxis(QPainter& painter) const {
    const QRectF area = lane(lane_count - 1);
    const double line = fontMetrics().height();
    const double label_width = fontMetrics().horizontalAdvance("00:00:00.0") + line;
    const double step = timeAxisStep(lengthSeconds(), std::max(2.0, area.width() / (1.6 * label_width)));
    for (double at = 0.0; at <= lengthSeconds() + 1e-9; at += step) {
        const double x = area.left() + area.width() * at / std::max(1e-9, lengthSeconds());
        painter.setPen(QPen(currentPalette().strong_line, 1.0));
        painter.drawLine(QPointF(x, area.bottom() + 1), QPointF(x, area.bottom() + 0.3 * line));
        painter.setPen(currentPalette().dim);
        QRectF label(x - label_width / 2, area.bottom() + 0.3 * line, label_width, line);
        if (label.right() > width()) label.moveRight(width());
        const QString text = elapsedText(at);
        painter.drawText(label, Qt::AlignCenter, step < 1.0 ? text : text.chopped(2));
    }
}

void TimelineView::paintLanes() {
    lanes_ = QPixmap(size() * devicePixelRatioF());
    lanes_.setDevicePixelRatio(devicePixelRatioF());
    const Palette& colours = currentPalette();
    lanes_.fill(colours.panel);
    QPainter painter(&lanes_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    const std::array<QString, lane_count> names{tr("Sweeps"), tr("Tracked")};
    for (int number = 0; number < lane_count; ++number) {
        const QRectF area = lane(number);
        painter.fillRect(area, colours.field);
        painter.setPen(colours.dim);
        painter.drawText(QRectF(fontMetrics().height() * 0.6, area.top(), area.left(), area.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, names[static_cast<std::size_t>(number)]);
    }
    if (!ready()) {
        painter.setPen(colours.dim);
        painter.drawText(lane(sweeps_lane).united(lane(tracked_lane)), Qt::AlignCenter, tr("no recording open"));
        return;
    }
    paintSweeps(painter);
    paintTracked(painter);
    paintRecalled(painter);
    paintGaps(painter);
    paintAxis(painter);
}

void TimelineView::paintLoop(QPainter& painter) const {
    if (!loop_ || !ready()) return;
    const double line = fontMetrics().height();
    const double left = xOf(loop_->begin);
    const QRectF bar(left, lane(0).top() - 0.3 * line, std::max(2.0, xOf(loop_->end) - left), 0.2 * line);
    painter.fillRect(bar, currentPalette().warning);
    painter.setPen(currentPalette().text);
    painter.drawText(QPointF(bar.left() - fontMetrics().horizontalAdvance("A") - 2, bar.bottom()), "A");
    painter.drawText(QPointF(bar.right() + 2, bar.bottom()), "B");
}

void TimelineView::paintHead(QPainter& painter, std::uint64_t position, bool solid) const {
    const double x = xOf(position);
    const double line = fontMetrics().height();
    const QRectF last = lane(lane_count - 1);
    painter.setPen(QPen(currentPalette().text, 1.5, solid ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(QPointF(x, 0.45 * line), QPointF(x, last.bottom()));
    if (!solid) return;
    QPainterPath handle;
    const double half = 0.28 * line;
    handle.moveTo(x - half, 1.0);
    handle.lineTo(x + half, 1.0);
    handle.lineTo(x + half, 0.35 * line);
    handle.lineTo(x, 0.65 * line);
    handle.lineTo(x - half, 0.35 * line);
    handle.closeSubpath();
    painter.fillPath(handle, currentPalette().text);
}

void TimelineView::paintEvent(QPaintEvent*) {
    if (lanes_.isNull()) paintLanes();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPixmap(0, 0, lanes_);
    if (!ready()) return;
    paintLoop(painter);
    if (pointer_x_ && *pointer_x_ >= lane(0).left() && *pointer_x_ <= lane(0).right()) {
        painter.setPen(QPen(currentPalette().dim, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(*pointer_x_, lane(0).top()), QPointF(*pointer_x_, lane(lane_count - 1).bottom()));
    }
    if (goal_ != position_) paintHead(painter, goal_, false);
    paintHead(painter, position_, true);
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && ready() && !live_) Q_EMIT seekRequested(positionAt(event->position().x()));
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    pointer_x_ = event->position().x();
    update();
    if (!ready()) return;
    const std::uint64_t position = positionAt(*pointer_x_);
    if (event->buttons().testFlag(Qt::LeftButton) && !live_) Q_EMIT seekRequested(position);
    QToolTip::showText(event->globalPosition().toPoint(), tipAt(position), this);
}

QString TimelineView::tipAt(std::uint64_t position) const {
    const auto& times = *timeline_.ping_times;
    const std::uint64_t index = std::max<std::uint64_t>(position, 1) - 1;
    const Timestamp time = times[index];
    const QString moment = Formatter::utc(time) + "\n" + elapsedText(secondsBetween(times.front(), time));
    if (!live_) return moment + "  " + tr("ping %1").arg(position);
    const auto within = [&](const PingSpan& span) { return span.begin <= index && index < span.end; };
    if (std::any_of(timeline_.gaps.begin(), timeline_.gaps.end(), within))
        return moment + "\n" + tr("Nothing came here then.");
    if (std::any_of(timeline_.recalled.begin(), timeline_.recalled.end(), within))
        return moment + "\n" + tr("Not seen here then; fetched into the copy of the recording.");
    return moment;
}

void TimelineView::leaveEvent(QEvent*) {
    pointer_x_.reset();
    update();
}

void TimelineView::resizeEvent(QResizeEvent*) { lanes_ = {}; }

void TimelineView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange || event->type() == QEvent::LanguageChange)
        lanes_ = {};
    QWidget::changeEvent(event);
}

}  // namespace echotrail
