#pragma once

#include "core/imaging/fan_projector.hpp"
#include "core/link/link_values.hpp"
#include "core/runtime/scene_builder.hpp"

#include <cstdint>
#include <map>
#include <optional>

namespace echotrail {

/// What a console shows of a tracker far away: put together from what came over the link, the picture painted by the
/// same code as aboard.
/// Order: events as the link's client gives them.
class RemoteScene {
public:
    using Params = ScanningSonarPipeline::Params;

    void take(const LinkEvent& event);
    /// Whether anything to be seen has changed since the last build().
    bool changed() const { return changed_; }
    /// A copy; the enhanced picture too where it is asked for.
    Scene build(bool enhanced);

    /// As the tracker says them; those it does not know here keep their defaults.
    const Params& params() const { return params_; }
    /// Why each of the tracker's parameters that this program cannot show was passed over: a tracker of another version
    /// may know others.
    const std::vector<std::string>& passedOver() const { return passed_over_; }
    const LinkHealth& health() const { return health_; }
    std::optional<Timestamp> lastPing() const;
    std::uint64_t sweep() const { return beam_.update.sweep; }  ///< of the last ping
    bool follows() const;                                       ///< at least one track is confirmed or coasting

private:
    void takeSnapshot(const LinkSnapshot& snapshot);
    void takeBeam(const LinkBeam& beam);
    void takeTracks(const LinkTracks& tracks);
    void takeClouds(const LinkClouds& clouds);
    void takeParameters(const LinkParameters& parameters);

    Params params_;
    std::vector<std::string> passed_over_;
    LinkHealth health_;
    FanProjector fan_{params_.fan};
    SceneBuilder builder_;
    std::map<int, Track> tracks_;
    LinkBeam beam_;  ///< the last
    bool has_beam_ = false, break_off_ = true, changed_ = false;
    std::optional<std::uint64_t> run_;
};

}  // namespace echotrail
