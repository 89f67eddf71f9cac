#include "core/filters/motion_model.hpp"

#include <cmath>

namespace echotrail {

GaussianState predicted(const GaussianState& state, Timestamp to, double q) {
    const double dt = secondsBetween(state.time, to), span = std::abs(dt);
    Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
    transition(0, 2) = transition(1, 3) = dt;
    Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
    for (int axis = 0; axis < 2; ++axis) {
        noise(axis, axis) = q * span * span * span / 3.0;
        noise(axis, axis + 2) = noise(axis + 2, axis) = q * dt * span / 2.0;
        noise(axis + 2, axis + 2) = q * span;
    }
    return {.time = to,
            .mean = transition * state.mean,
            .covariance = transition * state.covariance * transition.transpose() + noise};
}

GaussianState wandered(const GaussianState& state, Timestamp to, double sigma) {
    GaussianState next = state;
    next.time = to;
    next.covariance.topLeftCorner<2, 2>().diagonal().array() +=
        sigma * sigma * std::abs(secondsBetween(state.time, to));
    return next;
}

}  // namespace echotrail
