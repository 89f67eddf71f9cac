#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace echotrail {

/// What the command line sets over what a recording brings.
struct Overrides {
    std::vector<std::string> parameter_files, assignments;
    std::optional<std::uint64_t> seed;
    bool designation = false;  ///< a target was given: the recorded picks do not count
};

/// A run as a recording brings it, or from the defaults where it brings nothing, with the overrides over it.
class RecordedRunSettings {
public:
    static Result<RecordedRunSettings> of(const PingSource& source, Overrides overrides);

    const ScanningSonarPipeline::Params& params() const { return params_; }
    std::uint64_t seed() const { return seed_; }
    /// What of a recorded run does not count: "seed", "parameters", "designations".
    const std::vector<std::string>& overridden() const { return overridden_; }
    /// To be applied before the ping they came with.
    void apply(const std::vector<RunControl>& controls, ScanningSonarPipeline& pipeline);

private:
    Result<void> setParams(const std::string& recorded);

    Overrides overrides_;
    ScanningSonarPipeline::Params params_;
    std::uint64_t seed_ = 0;
    std::vector<std::string> overridden_;
};

}  // namespace echotrail
