#include "ui/panels/tracks/term_bar.hpp"

#include "ui/style/formatter.hpp"
#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace echotrail {

TermBar::TermBar(QWidget* parent) : QWidget(parent), term_(std::numeric_limits<double>::quiet_NaN()) {}

void TermBar::setTerm(double log_likelihood) {
    term_ = log_likelihood;
    setAccessibleName(Formatter::number(term_, 2));
    update();
}

QSize TermBar::sizeHint() const {
    return {fontMetrics().horizontalAdvance("−00.00") + UiMetrics(font()).pixels(40.0), fontMetrics().height()};
}

void TermBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Palette& colours = currentPalette();
    const UiMetrics metrics(font());
    const bool known = std::isfinite(term_);
    const bool bad = known && term_ < doubtful;
    painter.setPen(!known ? colours.off : bad ? colours.warning : colours.text);
    painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter, Formatter::number(term_, 2));
    if (!known) return;
    const double right = width() - fontMetrics().horizontalAdvance("−00.00") - metrics.length(2.0);
    const double length = std::clamp(term_ / longest, 0.0, 1.0) * right;
    const double height_px = metrics.length(7.0);
    painter.fillRect(QRectF(right - length, (height() - height_px) / 2.0, length, height_px),
                     bad ? colours.warning : colours.accent);
    painter.fillRect(QRectF(right, (height() - height_px) / 2.0 - 2.0, 1.0, height_px + 4.0), colours.strong_line);
}

}  // namespace echotrail
