#pragma once

#include <Eigen/Core>

#include <span>

namespace echotrail {

/// Whether a point lies in a closed polygon, both north and east in metres (even–odd rule).
bool isInside(const Eigen::Vector2f& point, std::span<const Eigen::Vector2f> polygon);

}  // namespace echotrail
