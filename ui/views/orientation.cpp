#include "ui/views/orientation.hpp"

#include "ui/views/beam_schedule.hpp"

#include <QCoreApplication>

namespace echotrail {
namespace {

QString text(const char* source) { return QCoreApplication::translate("FanView", source); }

}  // namespace

Bearing upOf(const Scene& scene, Orientation orientation) {
    const Bearing bow = scene.latest.pose.heading;
    if (orientation == Orientation::CourseUp) return headingKnown(scene) ? scene.course.value_or(bow) : bow;
    return orientation == Orientation::NorthUp ? Bearing() : bow;
}

QString missingInput(const Scene& scene, Orientation orientation) {
    if (orientation == Orientation::HeadUp) return {};
    if (orientation == Orientation::NorthUp) return headingKnown(scene) ? QString() : text("North up needs a heading");
    if (!headingKnown(scene)) return text("Course up needs heading and position");
    return scene.course ? QString() : text("Course up needs a vehicle that moves");
}

QString orientationBadge(Orientation orientation) {
    switch (orientation) {
        case Orientation::NorthUp:
            return text("NORTH UP");
        case Orientation::CourseUp:
            return text("COURSE UP");
        case Orientation::HeadUp:
            break;
    }
    return text("HEAD UP");
}

}  // namespace echotrail
