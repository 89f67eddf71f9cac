#include "core/data/polygon.hpp"

namespace echotrail {

bool isInside(const Eigen::Vector2f& point, std::span<const Eigen::Vector2f> polygon) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Eigen::Vector2f &a = polygon[i], &b = polygon[j];
        if ((a.y() > point.y()) == (b.y() > point.y())) continue;
        const float crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (point.x() < crossing) inside = !inside;
    }
    return inside;
}

}  // namespace echotrail
