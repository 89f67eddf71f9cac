#include "ui/style/ui_metrics.hpp"

#include <QFontInfo>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace echotrail {

UiMetrics::UiMetrics(const QFont& font) {
    // All fonts here are set in pixels; to ask the font database instead takes a tenth of the time of a start.
    const int set = font.pixelSize();
    scale_ = (set > 0 ? set : QFontInfo(font).pixelSize()) / base_pixel_size;
}

int UiMetrics::pixels(double at_base) const {
    return std::max(at_base > 0.0 ? 1 : 0, static_cast<int>(std::lround(length(at_base))));
}

QFont UiMetrics::sized(const QFont& font, double at_base, bool semibold) const {
    QFont other = font;
    other.setPixelSize(pixels(at_base));
    other.setWeight(semibold ? QFont::DemiBold : QFont::Normal);
    return other;
}

QFont applicationFont(double scale) {
    QFont font;
    font.setFamilies({"Noto Sans", "Noto Sans CJK SC", "DejaVu Sans"});
    font.setStyleHint(QFont::SansSerif);
    font.setPixelSize(static_cast<int>(std::lround(UiMetrics::base_pixel_size * scale)));
    return font;
}

QFont clockFont(const QFont& font) {
    QFont mono = font;
    mono.setFamilies({"DejaVu Sans Mono", "Noto Sans Mono"});
    mono.setStyleHint(QFont::Monospace);
    return mono;
}

}  // namespace echotrail
