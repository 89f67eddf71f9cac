#pragma once

#include <cstdint>
#include <vector>

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/data/head_settings.hpp"
#include "core/data/ping.hpp"
#include "core/data/pose.hpp"
#include "core/data/update.hpp"

namespace echotrail {

/// From pings to tracks. One object runs on board, in the console and on a recording; nothing in it knows which.
/// Order:   pings in time order; finish() once, after the last.
/// Threads: none; one owner calls it.
class ScanningSonarPipeline {
public:
    struct Params {
        HeadSettings head;
        bool operator==(const Params&) const = delete;
    };

    ScanningSonarPipeline(const Params& params, std::uint64_t seed);

    /// Takes in one ping. The update is valid until the next call.
    const Update& process(const Ping& ping, const PoseHistory& navigation);
    /// Closes the last sweep: the regions and looks that were still open.
    const Update& finish();

    /// Takes effect between two pings. Tracks live on.
    void setParams(const Params& params);
    const Params& params() const { return params_; }

    /// The operator's pick: the first region or track within max(3 m, 10 % of the range) of this place becomes the
    /// target, waiting as long as needed. The place is relative to the head at the latest ping (before any: the first).
    void designate(double range_m, Bearing from_bow);
    void clearDesignation();

    const std::vector<Track>& tracks() const { return tracks_; }
    /// The picture so far, in the local frame; empty before the first wedge, or when painting is off.
    const FanImage& fan() const { return fan_; }
    void setFanPainting(bool on);
    std::uint64_t confirmedTracks() const { return confirmed_; }  ///< at any time so far
    std::uint64_t sweeps() const { return sweeps_; }

private:
    Params params_;
    Update update_;
    std::vector<Track> tracks_;
    FanImage fan_;
    std::uint64_t confirmed_ = 0;
    std::uint64_t sweeps_ = 0;
};

template <>
struct Described<ScanningSonarPipeline::Params> {
    static constexpr auto stages = std::tuple{&ScanningSonarPipeline::Params::head};
};

}  // namespace echotrail
