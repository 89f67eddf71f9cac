#include "ui/forms/parameter_spin_box.hpp"

#include "core/base/parameters.hpp"

#include <QFocusEvent>
#include <QLineEdit>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace echotrail {

double handyStep(double minimum, double maximum, bool whole) {
    const double wish = (maximum - minimum) / 100.0;
    if (!(wish > 0.0)) return whole ? 1.0 : 0.1;
    const double power = std::pow(10.0, std::floor(std::log10(wish)));
    const double step = wish / power < 2.0 ? power : wish / power < 5.0 ? 2.0 * power : 5.0 * power;
    return whole ? std::max(1.0, std::round(step)) : step;
}

ParameterSpinBox::ParameterSpinBox(double minimum, double maximum, bool whole, QWidget* parent)
    : QAbstractSpinBox(parent),
      minimum_(minimum),
      maximum_(maximum),
      step_(handyStep(minimum, maximum, whole)),
      whole_(whole) {
    setFocusPolicy(Qt::StrongFocus);
    setAlignment(Qt::AlignRight);
}

void ParameterSpinBox::setTypedText(const QString& text) { lineEdit()->setText(text); }

void ParameterSpinBox::stepBy(int steps) {
    bool number = false;
    const double now = text().toDouble(&number);
    if (!number) return;
    // To the next multiple of the step, so that 14.3 goes to 15 and not to 15.3.
    const double place = now / step_;
    const double nearest = std::round(place);
    const bool on_grid = std::abs(place - nearest) < 1e-6;
    const double next = on_grid ? nearest + steps : (steps > 0 ? std::floor(place) : std::ceil(place)) + steps;
    const double value = std::clamp(next * step_, minimum_, maximum_);
    const double tidy = whole_ ? std::round(value) : std::round(value * 1e9) / 1e9;
    setTypedText(QString::fromStdString(ParameterInfo::toText(tidy)));
    Q_EMIT stepped();
}

/// What is typed replaces the value that was there; a click only puts the cursor.
void ParameterSpinBox::focusInEvent(QFocusEvent* event) {
    QAbstractSpinBox::focusInEvent(event);
    if (event->reason() != Qt::MouseFocusReason) selectAll();
}

void ParameterSpinBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QAbstractSpinBox::wheelEvent(event);
    else
        event->ignore();
}

}  // namespace echotrail
