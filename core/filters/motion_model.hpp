#pragma once

#include "core/data/track.hpp"

namespace echotrail {

/// The state at time `to` under constant velocity disturbed by white acceleration of spectral density `q` (m²/s³)
/// on each axis: mean Fμ, covariance FΣFᵀ + Q, with Q = q[[Δt³/3, Δt²/2], [Δt²/2, Δt]] per axis (position, velocity).
/// Exact for any Δt. A time before the state's is allowed (regions of one sweep come in the order they were
/// finished, not seen): the same model run backwards gives the noise of |Δt|, its off-diagonal terms negated.
GaussianState predicted(const GaussianState& state, Timestamp to, double q);

/// The state at time `to` where only the place is followed: it walks at random, its deviation growing by `sigma`
/// (m/√s) on each axis. This is the published state (method card, section f, state P); the velocity stays as it was.
GaussianState wandered(const GaussianState& state, Timestamp to, double sigma);

}  // namespace echotrail
