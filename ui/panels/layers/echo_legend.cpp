#include "ui/panels/layers/echo_legend.hpp"

#include "core/data/ping.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace echotrail {

EchoLegend::EchoLegend(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Echo level legend, 0 to 80 dB"));
}

void EchoLegend::setEcho(const EchoSettings& echo) {
    echo_ = echo;
    update();
}

QSize EchoLegend::sizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(160), metrics.pixels(34)};
}

void EchoLegend::paintEvent(QPaintEvent*) {
    const UiMetrics metrics(font());
    QPainter painter(this);
    const Palette& colours = currentPalette();
    const QRect bar(metrics.pixels(8), metrics.pixels(2), width() - metrics.pixels(16), metrics.pixels(12));
    const EchoColours& map = echoColours(echo_.map, currentTheme());
    const double span = std::max(echo_.white_db - echo_.black_db, 1.0);
    for (int x = 0; x < bar.width(); ++x) {
        const double db = full_scale_db * x / std::max(bar.width() - 1, 1);
        const double part = std::clamp((db - echo_.black_db) / span, 0.0, 1.0);
        painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(),
                         QColor(map[static_cast<int>(std::lround(part * 255))]));
    }
    painter.setPen(colours.strong_line);
    painter.drawRect(bar.adjusted(0, 0, -1, -1));
    painter.setFont(metrics.sized(font(), 10));
    painter.setPen(colours.dim);
    for (int db = 0; db <= 80; db += 20) {
        const int x = bar.left() + static_cast<int>(std::lround((bar.width() - 1) * db / full_scale_db));
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + metrics.pixels(3));
        const QString text = db == 80 ? tr("80 dB") : QString::number(db);
        const int wide = painter.fontMetrics().horizontalAdvance(text);
        const int left = std::clamp(x - wide / 2, 0, width() - wide);
        painter.drawText(left, bar.bottom() + metrics.pixels(4) + painter.fontMetrics().ascent(), text);
    }
}

}  // namespace echotrail
