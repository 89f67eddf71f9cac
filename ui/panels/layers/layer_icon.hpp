#pragma once

#include "ui/views/symbol_painter.hpp"

#include <QWidget>

namespace echotrail {

/// A layer's symbol as it looks on the fan.
class LayerIcon : public QWidget {
    Q_OBJECT

public:
    explicit LayerIcon(LayerSymbol symbol, QWidget* parent = nullptr);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    LayerSymbol symbol_;
};

}  // namespace echotrail
