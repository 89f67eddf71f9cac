#pragma once

#include <QPainter>
#include <cmath>

namespace echotrail {

/// While it lives, its painter works in the pixels of its device, whatever the scale of the screen: what was made in
/// pixels is copied as it is.
class DevicePixels {
public:
    explicit DevicePixels(QPainter& painter) : painter_(painter), world_(painter.worldTransform()) {
        if (toDevice().isIdentity()) return;
        const QTransform of_device = world_.inverted() * toDevice();
        painter_.setWorldTransform(of_device.inverted());
    }
    ~DevicePixels() { painter_.setWorldTransform(world_); }
    DevicePixels(const DevicePixels&) = delete;
    DevicePixels& operator=(const DevicePixels&) = delete;

    /// What may be painted on: the device, within the clip.
    QRectF visible() const {
        const QPaintDevice& device = *painter_.device();
        const QTransform of_device = painter_.worldTransform().inverted() * toDevice();
        QRectF box = of_device.mapRect(QRectF(0, 0, device.width(), device.height()));
        if (painter_.hasClipping()) box &= toDevice().mapRect(painter_.clipBoundingRect());
        return box;
    }

private:
    const QTransform& toDevice() const { return painter_.deviceTransform(); }

    QPainter& painter_;
    QTransform world_;
};

/// Device pixels for a length in the painter's coordinates.
inline double deviceScale(const QPainter& painter) {
    return std::sqrt(std::abs(painter.deviceTransform().determinant()));
}

}  // namespace echotrail
