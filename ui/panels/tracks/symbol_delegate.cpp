#include "ui/panels/tracks/symbol_delegate.hpp"

#include "ui/models/track_model.hpp"
#include "ui/style/ui_metrics.hpp"
#include "ui/views/symbol_painter.hpp"

#include <QPainter>

namespace echotrail {
namespace {

constexpr double symbol_scale = 0.72;  ///< of the fan's, so that the brackets fit into a row

}  // namespace

void SymbolDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->fillRect(option.rect, currentPalette().canvas);
    const auto state = static_cast<TrackState>(index.data(TrackModel::StateRole).toInt());
    const bool target = index.data(TrackModel::TargetRole).toBool();
    SymbolPainter(*painter, currentPalette(), symbol_scale * UiMetrics(option.font).scale())
        .target(QRectF(option.rect).center(), {state, target, false, {}, 0.0});
    painter->restore();
}

QSize SymbolDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const UiMetrics metrics(option.font);
    return {metrics.pixels(26.0), metrics.pixels(24.0)};
}

}  // namespace echotrail
