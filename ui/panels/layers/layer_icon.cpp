#include "ui/panels/layers/layer_icon.hpp"

#include "ui/style/ui_metrics.hpp"

namespace echotrail {

LayerIcon::LayerIcon(LayerSymbol symbol, QWidget* parent) : QWidget(parent), symbol_(symbol) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize LayerIcon::sizeHint() const {
    const UiMetrics metrics(font());
    return {metrics.pixels(26.0), metrics.pixels(20.0)};
}

void LayerIcon::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    SymbolPainter(painter, currentPalette(), UiMetrics(font()).scale()).layer(rect(), symbol_);
}

}  // namespace echotrail
