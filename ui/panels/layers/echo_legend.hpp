#pragma once

#include "ui/views/fan_settings.hpp"

#include <QWidget>

namespace echotrail {

/// The echo map as a bar from black to white level, with ticks in dB.
class EchoLegend : public QWidget {
public:
    explicit EchoLegend(QWidget* parent = nullptr);
    void setEcho(const EchoSettings& echo);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    EchoSettings echo_;
};

}  // namespace echotrail
