#pragma once

// clang-format off: moc of Qt 6.4 stumbles over <compare> and <numbers> where it meets them first
#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/angles.hpp"
#include "core/base/time.hpp"
#include "core/data/region.hpp"
// clang-format on

namespace echotrail {

enum class TrackState { Tentative, Confirmed, Coasting, Lost };

/// "tentative", "confirmed", "coasting", "lost".
std::string_view toText(TrackState state);

/// Why a look used no echo, as far as can be told without knowing where the target truly was.
enum class NoEcho {
    None,                ///< one was used
    OutsideSector,       ///< sweeps were finished, and none passed over the place
    NotYetScanned,       ///< the beam has not come by yet
    UnderThreshold,      ///< the beam was there, and nothing stood out
    Merged,              ///< what was there had run into something larger
    TakenByAnother,      ///< what was there is another track's
    OutscoredByClutter,  ///< what was there was more likely clutter
    NavigationGap,       ///< poses were missing since the last look
    PingsMissing         ///< pings were missing since the last look: the head restarted, or the link was lost
};
inline constexpr int no_echo_causes = static_cast<int>(NoEcho::PingsMissing) + 1;

/// "under the threshold", …; nothing where an echo was used.
std::string_view toText(NoEcho cause);

/// A Gaussian over position and velocity in the local frame: north, east (m), north, east (m/s).
struct GaussianState {
    Timestamp time{};
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
};

/// A part of a ring about the head, in the local frame: where a track is expected.
struct PolarBox {
    double north_m = 0.0;  ///< of the head
    double east_m = 0.0;
    Bearing centre;  ///< from north
    double half_width_rad = 0.0;
    double near_m = 0.0;
    double far_m = 0.0;
};

/// Particles of a track's last update, weights adding up to 1.
struct ParticleCloud {
    std::vector<Eigen::Vector2f> position_m;  ///< north, east
    std::vector<float> weight;
    double effective = 0.0;        ///< effective sample size 1 / sum of squared weights
    std::size_t thinned_from = 0;  ///< particles there are, where a link has left some out; else 0

    /// As the effective number counts them.
    std::size_t size() const { return thinned_from > weight.size() ? thinned_from : weight.size(); }
};

/// One pass of the beam over a track's place: a line of the tracks file.
struct TrackLook {
    Timestamp time{};  ///< when the beam was there
    int track = 0;
    TrackState state = TrackState::Tentative;
    bool target = false;            ///< the operator's designated one
    bool seen = false;              ///< an echo was used; else a prediction
    NoEcho no_echo = NoEcho::None;  ///< why not, where that is known
    double range_m = 0.0;           ///< from the head at `time`
    Bearing bearing;                ///< from the bow at `time`
    Eigen::Vector2d position_m{0, 0};
    Eigen::Vector2d velocity_mps{0, 0};
    Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Identity();
};

/// A followed object, as it stands after the last ping.
struct Track {
    int id = 0;  ///< counts from 1, never reused within a run
    TrackState state = TrackState::Tentative;
    bool target = false;
    GaussianState estimate;  ///< at the time of the last look
    Timestamp born{};
    Timestamp last_seen{};      ///< last look that used an echo
    double existence = 0.0;     ///< probability that there is something to follow
    int looks = 0;              ///< with an echo
    int misses = 0;             ///< looks without one since the last echo
    double score = 0.0;         ///< likeness of the last echo to the reference, 0…1
    double innovation_m = 0.0;  ///< distance of the last echo from its prediction
    double nis = 0.0;           ///< normalised innovation squared of the last echo
    RegionFeatures seen_features;
    RegionFeatures expected_features;
    PolarBox region_of_interest;  ///< where the next echo is expected
    ParticleCloud particles;
    std::vector<TrackLook> history;  ///< the last looks, oldest first
};

}  // namespace echotrail
