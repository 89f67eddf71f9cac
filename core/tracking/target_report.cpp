#include "core/tracking/target_report.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr double dangerous_m = 5.0, horizon_s = 30.0;

/// When two that keep their velocities are nearest, from now on.
double timeToClosest(const Eigen::Vector2d& place, const Eigen::Vector2d& velocity) {
    const double speed_squared = velocity.squaredNorm();
    return speed_squared > 0.0 ? std::max(0.0, -place.dot(velocity) / speed_squared) : 0.0;
}

}  // namespace

TargetReport reportOn(const Track& track, const OwnMotion& own, Timestamp time) {
    const double ahead_s = secondsBetween(track.estimate.time, time);
    Eigen::Matrix4d move = Eigen::Matrix4d::Identity();
    move(0, 2) = move(1, 3) = ahead_s;
    const Eigen::Vector4d mean = move * track.estimate.mean;
    const Eigen::Matrix4d covariance = move * track.estimate.covariance * move.transpose();
    const Eigen::Vector2d velocity = mean.tail<2>() - own.velocity_mps;
    const Eigen::Vector2d place = mean.head<2>() - Eigen::Vector2d(own.pose.north_m, own.pose.east_m);

    TargetReport report;
    report.look = {.time = time,
                   .track = track.id,
                   .state = track.state,
                   .target = track.target,
                   .seen = false,
                   .range_m = place.norm(),
                   .bearing = Bearing::radians(std::atan2(place.y(), place.x()) - own.pose.heading.inRadians()),
                   .position_m = mean.head<2>(),
                   .velocity_mps = mean.tail<2>(),
                   .covariance_m2 = covariance.topLeftCorner<2, 2>()};
    report.age_s = secondsBetween(track.last_seen, time);
    report.valid = track.state == TrackState::Confirmed || track.state == TrackState::Coasting;
    report.time_to_closest_s = timeToClosest(place, velocity);
    report.closest_approach_m = (place + velocity * report.time_to_closest_s).norm();

    double near = 0.0, all = 0.0;
    const Eigen::Vector2d shift =
        place - track.estimate.mean.head<2>();  // from where a particle was to where it is now
    for (std::size_t i = 0; i < track.particles.position_m.size(); ++i) {
        const Eigen::Vector2d particle = track.particles.position_m[i].cast<double>() + shift;
        const double nearest_s = std::min(timeToClosest(particle, velocity), horizon_s);
        const double weight = static_cast<double>(track.particles.weight[i]);
        all += weight;
        if ((particle + velocity * nearest_s).norm() < dangerous_m) near += weight;
    }
    report.risk = all > 0.0 ? near / all : 0.0;
    return report;
}

}  // namespace echotrail
