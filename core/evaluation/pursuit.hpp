#pragma once

#include "core/evaluation/pursuit_record.hpp"
#include "core/pipelines/scanning_sonar_pipeline.hpp"
#include "core/simulation/pursuing_vehicle.hpp"

#include <cstdint>
#include <functional>

namespace echotrail {

struct PursuitResult {
    PursuitRecord record;
    std::uint64_t pings = 0, looks = 0;    ///< looks: at the target, with an echo
    std::uint64_t reports = 0, valid = 0;  ///< that the vehicle was sent; that it could steer by
    int picks = 0;                         ///< how often the operator had to point at the target
};

/// The whole loop of a trial, in one process and as fast as the machine can: the head hears the scenario, the pipeline
/// follows the target, and a vehicle that knows nothing but its reports (the lines of `--report`, made and read as
/// there) follows it and carries the head. Where `follow_target` is set, the head looks where the pipeline wants it to.
/// An operator points at the target at the start, and again when it has been lost for 30 s. The scenario has a target.
/// The same arguments give the same result. Stops early when `cancelled` says so.
PursuitResult runPursuit(const Scenario& scenario, const ScanningSonarPipeline::Params& params,
                         const PursuitParams& pursuit, std::uint64_t seed,
                         const std::function<bool()>& cancelled = {});

}  // namespace echotrail
