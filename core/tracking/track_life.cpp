#include "core/tracking/track_life.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace echotrail {

namespace {

/// Along the longer axis of the ellipse, metres.
double positionSigma(const Track& track) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(track.estimate.covariance.topLeftCorner<2, 2>(),
                                                              Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(axes.eigenvalues().y(), 0.0));
}

}  // namespace

double existenceAfter(double existence, double likelihood_ratio) {
    const double weighted = likelihood_ratio * existence;
    const double after = weighted / (1.0 - existence + weighted);
    return std::clamp(after, 1e-6, 1.0 - 1e-6);
}

void advanceLife(Track& track, LookResult result, double likelihood_ratio, Timestamp time, const LifeParams& params) {
    if (result == LookResult::NotLookedAt) return;
    track.existence = existenceAfter(track.existence, likelihood_ratio);
    if (result == LookResult::Seen) {
        ++track.looks;
        track.misses = 0;
        track.last_seen = time;
    } else {
        ++track.misses;
    }
    switch (track.state) {
        case TrackState::Tentative:
            if (track.existence > params.confirm_existence && track.looks >= params.confirm_looks &&
                positionSigma(track) <= params.confirm_sigma_m)
                track.state = TrackState::Confirmed;
            break;
        case TrackState::Confirmed:
        case TrackState::Coasting:
            track.state = result == LookResult::Seen ? TrackState::Confirmed : TrackState::Coasting;
            if (track.existence < params.lost_existence || track.misses >= params.lost_misses)
                track.state = TrackState::Lost;
            break;
        case TrackState::Lost:
            break;
    }
}

void reacquire(Track& track, Timestamp time) {
    track.state = TrackState::Confirmed;
    track.existence = std::max(track.existence, 0.5);
    track.misses = 0;
    track.last_seen = time;
}

void widenSearch(Track& track, const LifeParams& params) {
    auto& covariance = track.estimate.covariance;
    covariance.topLeftCorner<2, 2>() *= params.miss_widening;
    // Scaling rows and columns alike keeps the matrix positive definite. The trace is at least the larger eigenvalue.
    const double position = covariance.topLeftCorner<2, 2>().trace(),
                 speed = covariance.bottomRightCorner<2, 2>().trace();
    const double widest = params.widest_sigma_m * params.widest_sigma_m;
    const double fastest = params.widest_sigma_mps * params.widest_sigma_mps;
    Eigen::Vector4d scale = Eigen::Vector4d::Ones();
    scale.head<2>().setConstant(std::min(1.0, std::sqrt(widest / position)));
    scale.tail<2>().setConstant(std::min(1.0, std::sqrt(fastest / speed)));
    covariance = (scale.asDiagonal() * covariance * scale.asDiagonal()).eval();
}

bool isForgotten(const Track& track, Timestamp now, const LifeParams& params) {
    const double silent_s = secondsBetween(track.last_seen, now);
    if (track.state == TrackState::Tentative)
        return track.existence < params.lost_existence || track.misses >= params.tentative_misses ||
               silent_s > params.lost_after_s;
    return track.state == TrackState::Lost && silent_s > params.remember_s;
}

}  // namespace echotrail
