#pragma once

#include "core/base/result.hpp"
#include "core/simulation/simulated_source.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

/// Where the targets truly were, at any time of a run: straight between samples.
class Truth {
public:
    /// A target at a moment. A file may give the place in the local frame, or as seen from the head, or both.
    struct Sample {
        Timestamp time{};
        bool has_place = false;
        Eigen::Vector2d position_m{0, 0};    ///< north, east
        Eigen::Vector2d velocity_mps{0, 0};  ///< over ground; zero where it is not known
        bool has_sight = false;
        double range_m = 0.0;  ///< from the head
        Bearing from_bow;
        bool visible = false;  ///< inside the scanned sector and range
    };

    Truth() = default;
    /// As the simulation knows it.
    explicit Truth(const std::vector<TruthSample>& samples);

    /// Reads either of the two CSV forms; `start` is the time of the source's first ping. The error names the line.
    static Result<Truth> read(std::string_view csv, Timestamp start);

    /// Whether it says how fast targets are; as seen from the head it does not.
    bool hasVelocities() const;
    int targets() const { return static_cast<int>(samples_.size()); }
    /// Empty outside the target's samples.
    std::optional<Sample> at(int target, Timestamp time) const;

private:
    std::vector<std::vector<Sample>> samples_;  ///< [target], in time order
};

}  // namespace echotrail
