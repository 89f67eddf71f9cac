#pragma once

#include <QAbstractSpinBox>

namespace echotrail {

/// A field for a number with − and +, that takes any text: a value that is refused must be seen being refused, with
/// the reason, and not be bent silently into the limits.
/// The wheel acts only while the field has the focus, so that scrolling past never changes a value.
class ParameterSpinBox : public QAbstractSpinBox {
    Q_OBJECT

public:
    /// `whole`: steps are whole numbers.
    ParameterSpinBox(double minimum, double maximum, bool whole, QWidget* parent = nullptr);
    QString typedText() const { return text(); }
    void setTypedText(const QString& text);

    void stepBy(int steps) override;
    QValidator::State validate(QString&, int&) const override { return QValidator::Acceptable; }

Q_SIGNALS:
    void stepped();

protected:
    StepEnabled stepEnabled() const override { return StepUpEnabled | StepDownEnabled; }
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    double minimum_;
    double maximum_;
    double step_;
    bool whole_;
};

/// A handy step for limits this far apart: about a hundredth of them, as 1, 2 or 5 times a power of ten.
double handyStep(double minimum, double maximum, bool whole);

}  // namespace echotrail
