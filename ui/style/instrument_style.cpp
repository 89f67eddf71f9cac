#include "ui/style/instrument_style.hpp"

#include "ui/style/palette.hpp"
#include "ui/style/ui_metrics.hpp"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>

namespace echotrail {
namespace {

UiMetrics metricsOf(const QWidget* widget) { return UiMetrics(widget ? widget->font() : QApplication::font()); }

bool isOn(const QStyleOption& option, QStyle::StateFlag flag) { return option.state.testFlag(flag); }

/// A control's ground with its edge: stronger where it has the focus or is the default.
void drawBox(QPainter& painter, const QRect& rect, const QColor& fill, const QColor& edge, double width,
             const UiMetrics& metrics) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge, width));
    painter.setBrush(fill);
    const double inset = width / 2.0;
    const double radius = metrics.length(2.0);
    painter.drawRoundedRect(QRectF(rect).adjusted(inset, inset, -inset, -inset), radius, radius);
    painter.restore();
}

void drawArrow(QPainter& painter, const QRect& rect, int quarter_turns, const QColor& colour,
               const UiMetrics& metrics) {
    const double half = metrics.length(3.5);
    QPainterPath arrow;
    arrow.moveTo(-half, -half / 2.0);
    arrow.lineTo(half, -half / 2.0);
    arrow.lineTo(0, half / 2.0);
    arrow.closeSubpath();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect).center());
    painter.rotate(90.0 * quarter_turns);
    painter.fillPath(arrow, colour);
    painter.restore();
}

void drawCheckMark(QPainter& painter, const QStyleOption& option, const UiMetrics& metrics) {
    const Palette& colours = currentPalette();
    const bool enabled = isOn(option, QStyle::State_Enabled);
    const bool focus = isOn(option, QStyle::State_HasFocus);
    drawBox(painter, option.rect, colours.field,
            !enabled ? colours.line
            : focus  ? colours.accent
                     : colours.dim,
            metrics.length(focus ? 1.5 : 1.0), metrics);
    if (isOn(option, QStyle::State_Off)) return;
    const QRectF box(option.rect);
    const auto at = [&](double x, double y) { return QPointF(box.x() + x * box.width(), box.y() + y * box.height()); };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(
        QPen(enabled ? colours.text : colours.off, metrics.length(1.8), Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    if (isOn(option, QStyle::State_NoChange)) {
        painter.drawLine(at(0.28, 0.5), at(0.72, 0.5));
    } else {
        const std::array mark{at(0.24, 0.52), at(0.42, 0.70), at(0.77, 0.31)};
        painter.drawPolyline(mark.data(), static_cast<int>(mark.size()));
    }
    painter.restore();
}

void drawRadioMark(QPainter& painter, const QStyleOption& option, const UiMetrics& metrics) {
    const Palette& colours = currentPalette();
    const bool enabled = isOn(option, QStyle::State_Enabled);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(enabled ? colours.dim : colours.line, metrics.length(1.0)));
    painter.setBrush(colours.field);
    const QRectF box = QRectF(option.rect).adjusted(1, 1, -1, -1);
    painter.drawEllipse(box);
    if (isOn(option, QStyle::State_On)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(enabled ? colours.text : colours.off);
        const double inset = box.width() * 0.28;
        painter.drawEllipse(box.adjusted(inset, inset, -inset, -inset));
    }
    painter.restore();
}

/// Push and tool buttons: the chosen one of several, and the default, have the accent's edge.
void drawButton(QPainter& painter, const QStyleOption& option, bool is_default, const UiMetrics& metrics) {
    const Palette& colours = currentPalette();
    const bool enabled = isOn(option, QStyle::State_Enabled);
    const bool strong = enabled && (is_default || isOn(option, QStyle::State_On));
    const bool focus = enabled && isOn(option, QStyle::State_HasFocus);
    QColor fill = isOn(option, QStyle::State_Sunken) ? colours.selected : colours.raised;
    if (!enabled) fill = colours.panel;
    const QColor edge = strong || focus                         ? colours.accent
                        : !enabled                              ? colours.line
                        : isOn(option, QStyle::State_MouseOver) ? colours.dim
                                                                : colours.strong_line;
    drawBox(painter, option.rect, fill, edge, metrics.length(strong ? 2.0 : 1.0), metrics);
    if (strong && focus)
        drawBox(painter, option.rect.adjusted(3, 3, -3, -3), Qt::transparent, colours.accent, metrics.length(1.0),
                metrics);
}

void drawFieldBox(QPainter& painter, const QStyleOption& option, const UiMetrics& metrics) {
    const Palette& colours = currentPalette();
    const bool enabled = isOn(option, QStyle::State_Enabled);
    const bool focus = enabled && isOn(option, QStyle::State_HasFocus);
    drawBox(painter, option.rect, enabled ? colours.field : colours.panel,
            focus     ? colours.accent
            : enabled ? colours.strong_line
                      : colours.line,
            metrics.length(focus ? 1.5 : 1.0), metrics);
}

}  // namespace

InstrumentStyle::InstrumentStyle() : QProxyStyle("Fusion") {}

void InstrumentStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                    const QWidget* widget) const {
    const UiMetrics metrics = metricsOf(widget);
    const bool enabled = isOn(*option, State_Enabled);
    const QColor& ink = enabled ? currentPalette().text : currentPalette().off;
    switch (element) {
        case PE_IndicatorCheckBox:
        case PE_IndicatorItemViewItemCheck:
            return drawCheckMark(*painter, *option, metrics);
        case PE_IndicatorRadioButton:
            return drawRadioMark(*painter, *option, metrics);
        case PE_IndicatorArrowDown:
            return drawArrow(*painter, option->rect, 0, ink, metrics);
        case PE_IndicatorArrowLeft:
            return drawArrow(*painter, option->rect, 1, ink, metrics);
        case PE_IndicatorArrowUp:
            return drawArrow(*painter, option->rect, 2, ink, metrics);
        case PE_IndicatorArrowRight:
            return drawArrow(*painter, option->rect, 3, ink, metrics);
        case PE_PanelLineEdit:
            return drawFieldBox(*painter, *option, metrics);
        case PE_FrameLineEdit:
            return;  // the panel has drawn the edge
        case PE_PanelButtonTool:
            if (isOn(*option, State_AutoRaise) && !isOn(*option, State_MouseOver) && !isOn(*option, State_Sunken) &&
                !isOn(*option, State_On))
                return;
            return drawButton(*painter, *option, false, metrics);
        case PE_FrameFocusRect:
            painter->save();
            painter->setPen(QPen(currentPalette().accent, 1.0));
            painter->setBrush(Qt::NoBrush);
            painter->drawRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
            painter->restore();
            return;
        default:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void InstrumentStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                  const QWidget* widget) const {
    if (element == CE_PushButtonBevel) {
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        const bool is_default = button && button->features.testFlag(QStyleOptionButton::DefaultButton);
        return drawButton(*painter, *option, is_default, metricsOf(widget));
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void InstrumentStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                         const QWidget* widget) const {
    const UiMetrics metrics = metricsOf(widget);
    const Palette& colours = currentPalette();
    const QColor& ink = isOn(*option, State_Enabled) ? colours.dim : colours.off;
    if (control == CC_ComboBox) {
        drawFieldBox(*painter, *option, metrics);
        return drawArrow(*painter, proxy()->subControlRect(control, option, SC_ComboBoxArrow, widget), 0, ink, metrics);
    }
    if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option); control == CC_SpinBox && spin) {
        if (spin->frame) drawFieldBox(*painter, *option, metrics);
        if (spin->buttonSymbols == QAbstractSpinBox::NoButtons) return;
        const bool up = spin->stepEnabled.testFlag(QAbstractSpinBox::StepUpEnabled);
        const bool down = spin->stepEnabled.testFlag(QAbstractSpinBox::StepDownEnabled);
        drawArrow(*painter, proxy()->subControlRect(control, option, SC_SpinBoxUp, widget), 2, up ? ink : colours.off,
                  metrics);
        return drawArrow(*painter, proxy()->subControlRect(control, option, SC_SpinBoxDown, widget), 0,
                         down ? ink : colours.off, metrics);
    }
    if (const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
        control == CC_Slider && slider && slider->orientation == Qt::Horizontal) {
        const QRect groove = proxy()->subControlRect(control, option, SC_SliderGroove, widget);
        const QRect handle = proxy()->subControlRect(control, option, SC_SliderHandle, widget);
        const int thick = metrics.pixels(2.0);
        const QRect line(groove.x(), groove.center().y() - thick / 2, groove.width(), thick);
        painter->fillRect(line, colours.strong_line);
        const bool enabled = isOn(*option, State_Enabled);
        if (enabled)
            painter->fillRect(QRect(line.topLeft(), QPoint(handle.center().x(), line.bottom())), colours.accent);
        const int half = metrics.pixels(4.0);
        const QRect knob(handle.center().x() - half, handle.y() + 1, 2 * half, handle.height() - 2);
        return drawBox(*painter, knob, colours.raised, enabled && isOn(*option, State_HasFocus) ? colours.accent : ink,
                       metrics.length(1.0), metrics);
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

int InstrumentStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                               QStyleHintReturn* result) const {
    switch (hint) {
        case SH_Widget_Animation_Duration:
            return 0;
        case SH_EtchDisabledText:
        case SH_DitherDisabledText:
            return 0;
        case SH_Slider_AbsoluteSetButtons:
            return Qt::LeftButton;
        default:
            return QProxyStyle::styleHint(hint, option, widget, result);
    }
}

int InstrumentStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
    const UiMetrics metrics = metricsOf(widget);
    switch (metric) {
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
            return metrics.pixels(13.0);
        case PM_SmallIconSize:
        case PM_ButtonIconSize:
            return metrics.pixels(16.0);
        case PM_ScrollBarExtent:
            return metrics.pixels(10.0);
        case PM_DockWidgetSeparatorExtent:
        case PM_SplitterWidth:
            return metrics.pixels(3.0);
        case PM_LayoutHorizontalSpacing:
        case PM_LayoutVerticalSpacing:
            return metrics.pixels(4.0);
        case PM_LayoutLeftMargin:
        case PM_LayoutRightMargin:
        case PM_LayoutTopMargin:
        case PM_LayoutBottomMargin:
            return metrics.pixels(8.0);
        default:
            return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

}  // namespace echotrail
