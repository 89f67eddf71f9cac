#pragma once

#include <QToolButton>

namespace echotrail {

/// A button with a drawn transport sign, in the colour of the palette's text: fonts do not agree on these glyphs.
class TransportButton : public QToolButton {
    Q_OBJECT

public:
    enum class Sign { ToStart, StepBack, Play, Pause, StepForward, ToEnd };

    explicit TransportButton(Sign sign, QWidget* parent = nullptr);
    void setName(const QString& name, const QString& keys);
    void setSign(Sign sign);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Sign sign_;
};

}  // namespace echotrail
