#include "ui/panels/tracks/strip_chart.hpp"

#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace echotrail {
namespace {

constexpr double lane_height = 28.0;  ///< lengths in px at scale 1
constexpr double lane_gap = 2.0;
constexpr double axis_height = 16.0;
constexpr int name_characters = 13;

}  // namespace

double chartSpan(double seconds) {
    for (const double span : {60.0, 120.0, 300.0, 600.0, 1800.0})
        if (seconds <= span) return span;
    return 3600.0 * std::ceil(seconds / 3600.0);
}

StripChart::StripChart(QWidget* parent) : QWidget(parent) { setAccessibleName(tr("Course of the track's values")); }

void StripChart::setStrips(std::vector<Strip> strips, Timestamp now, double span_s) {
    const bool other_size = strips.size() != strips_.size();
    strips_ = std::move(strips);
    now_ = now;
    span_s_ = span_s;
    QStringList words;
    for (const Strip& strip : strips_) words << strip.name + " " + strip.value;
    setAccessibleDescription(words.join(", "));
    if (other_size) updateGeometry();
    update();
}

QSize StripChart::sizeHint() const {
    const UiMetrics metrics(font());
    const double lanes = static_cast<double>(strips_.size()) * (lane_height + lane_gap);
    return {fontMetrics().averageCharWidth() * 40, metrics.pixels(lanes + axis_height)};
}

QRectF StripChart::lane(std::size_t number) const {
    const UiMetrics metrics(font());
    const double left = fontMetrics().averageCharWidth() * name_characters;
    return {left, static_cast<double>(number) * metrics.length(lane_height + lane_gap),
            std::max(10.0, width() - left - metrics.length(8.0)), metrics.length(lane_height)};
}

StripChart::Axis StripChart::axisOf(const Strip& strip) {
    Axis axis{strip.limit.value_or(0.0), strip.limit.value_or(0.0)};
    bool any = strip.limit.has_value();
    for (const Strip::Point& point : strip.points) {
        axis.low = any ? std::min(axis.low, point.value) : point.value;
        axis.high = any ? std::max(axis.high, point.value) : point.value;
        any = true;
    }
    if (strip.from_zero) axis.low = std::min(0.0, axis.low);
    const double missing = std::max(0.0, strip.least_span - (axis.high - axis.low));
    axis.high += strip.from_zero ? missing : missing / 2.0;
    axis.low -= strip.from_zero ? 0.0 : missing / 2.0;
    return axis;
}

QPointF StripChart::placeOf(std::size_t number, const Strip::Point& point) const {
    const QRectF area = lane(number).adjusted(0, 3, 0, -3);
    const Axis axis = axisOf(strips_[number]);
    const double x = area.right() - area.width() * secondsBetween(point.time, now_) / span_s_;
    const double part = std::clamp((point.value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
    return {x, area.bottom() - part * area.height()};
}

void StripChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t number = 0; number < strips_.size(); ++number) paintLane(painter, number);
    if (!strips_.empty()) paintTimes(painter);
}

void StripChart::paintLane(QPainter& painter, std::size_t number) const {
    const Palette& colours = currentPalette();
    const UiMetrics metrics(font());
    const Strip& strip = strips_[number];
    const QRectF area = lane(number);
    const QRectF words(0, area.top(), area.left() - metrics.length(6.0), area.height() / 2.0);
    painter.fillRect(area, colours.field);
    painter.setFont(metrics.sized(font(), 11.0));
    painter.setPen(colours.dim);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, strip.name);
    const bool above = strip.limit && !strip.points.empty() && strip.points.back().value > *strip.limit;
    painter.setFont(metrics.sized(font(), 12.0, true));
    painter.setPen(above ? colours.warning : colours.text);
    painter.drawText(words.translated(0, words.height()), Qt::AlignLeft | Qt::AlignVCenter, strip.value);
    painter.save();
    painter.setClipRect(area);
    if (strip.limit) {
        const double y = placeOf(number, {now_, *strip.limit}).y();
        painter.setPen(QPen(colours.warning, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    }
    paintValues(painter, number);
    painter.restore();
}

void StripChart::paintValues(QPainter& painter, std::size_t number) const {
    const Palette& colours = currentPalette();
    const UiMetrics metrics(font());
    const Strip& strip = strips_[number];
    QPolygonF line;
    for (const Strip::Point& point : strip.points) {
        const QPointF place = placeOf(number, point);
        line << place;
        if (strip.bars) {
            const bool above = strip.limit && point.value > *strip.limit;
            painter.setPen(
                QPen(above ? colours.warning : colours.accent, metrics.length(2.0), Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(QPointF(place.x(), lane(number).bottom()), place);
        }
    }
    if (strip.bars) return;
    painter.setPen(QPen(colours.accent, metrics.length(1.3)));
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    for (const Strip::Point& point : strip.points)
        if (point.marked) painter.drawEllipse(placeOf(number, point), metrics.length(1.3), metrics.length(1.3));
}

void StripChart::paintTimes(QPainter& painter) const {
    const UiMetrics metrics(font());
    const QRectF area = lane(strips_.size() - 1);
    const QRectF row(area.left(), area.bottom(), area.width(), metrics.length(axis_height));
    painter.setFont(metrics.sized(font(), 10.0));
    painter.setPen(currentPalette().dim);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, Formatter::number(-span_s_, 0) + " s");
    painter.drawText(row, Qt::AlignHCenter | Qt::AlignVCenter, Formatter::number(-span_s_ / 2.0, 0));
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, tr("now"));
}

}  // namespace echotrail
