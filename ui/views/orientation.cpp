#include "ui/views/orientation.hpp"

#include "ui/views/beam_schedule.hpp"
#include "ui/views/fan_text.hpp"

namespace echotrail {
namespace {}  // namespace

Bearing upOf(const Scene& scene, Orientation orientation) {
    const Bearing bow = scene.latest.pose.heading;
    if (orientation == Orientation::CourseUp) return headingKnown(scene) ? scene.course.value_or(bow) : bow;
    return orientation == Orientation::NorthUp ? Bearing() : bow;
}

QString missingInput(const Scene& scene, Orientation orientation) {
    if (orientation == Orientation::HeadUp) return {};
    if (orientation == Orientation::NorthUp)
        return headingKnown(scene) ? QString() : FanText::tr("North up needs a heading");
    if (!headingKnown(scene)) return FanText::tr("Course up needs heading and position");
    return scene.course ? QString() : FanText::tr("Course up needs a vehicle that moves");
}

QString orientationBadge(Orientation orientation) {
    switch (orientation) {
        case Orientation::NorthUp:
            return FanText::tr("NORTH UP");
        case Orientation::CourseUp:
            return FanText::tr("COURSE UP");
        case Orientation::HeadUp:
            break;
    }
    return FanText::tr("HEAD UP");
}

}  // namespace echotrail
