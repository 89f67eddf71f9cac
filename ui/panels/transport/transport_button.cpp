#include "ui/panels/transport/transport_button.hpp"

#include <QPainter>
#include <QPainterPath>

namespace echotrail {
namespace {

/// In a square of side 1 about the origin.
QPainterPath signPath(TransportButton::Sign sign) {
    QPainterPath path;
    const auto triangle = [&](double tip, double base) {
        path.moveTo(base, -0.4);
        path.lineTo(tip, 0.0);
        path.lineTo(base, 0.4);
        path.closeSubpath();
    };
    const auto bar = [&](double x) { path.addRect(x - 0.06, -0.4, 0.12, 0.8); };
    switch (sign) {
        case TransportButton::Sign::ToStart:
            bar(-0.42), triangle(-0.36, 0.4);
            break;
        case TransportButton::Sign::StepBack:
            triangle(-0.42, 0.12), bar(0.32);
            break;
        case TransportButton::Sign::Play:
            triangle(0.45, -0.35);
            break;
        case TransportButton::Sign::Pause:
            path.addRect(-0.32, -0.4, 0.22, 0.8), path.addRect(0.1, -0.4, 0.22, 0.8);
            break;
        case TransportButton::Sign::StepForward:
            bar(-0.32), triangle(0.42, -0.12);
            break;
        case TransportButton::Sign::ToEnd:
            triangle(0.36, -0.4), bar(0.42);
            break;
    }
    return path;
}

}  // namespace

TransportButton::TransportButton(Sign sign, QWidget* parent) : QToolButton(parent), sign_(sign) {
    setFocusPolicy(Qt::TabFocus);
}

void TransportButton::setName(const QString& name, const QString& keys) {
    setAccessibleName(name);
    setToolTip(name + " (" + keys + ")");
}

void TransportButton::setSign(Sign sign) {
    sign_ = sign;
    update();
}

QSize TransportButton::sizeHint() const {
    const int height = fontMetrics().height() * 3 / 2;
    return {height * 5 / 4, height};
}

void TransportButton::paintEvent(QPaintEvent* event) {
    QToolButton::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    const double side = 0.62 * fontMetrics().height();
    painter.scale(side, side);
    painter.fillPath(signPath(sign_),
                     palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::ButtonText));
}

}  // namespace echotrail
