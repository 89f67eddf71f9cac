#pragma once

#include "exit_code.hpp"

#include <CLI/App.hpp>

#include <functional>
#include <memory>

namespace echotrail {

/// A command adds its options to the program and is called when the command line names it.
using Command = std::function<ExitCode()>;

/// `echotrail track`: the onboard tracker.
Command addTrackCommand(CLI::App& program);

/// `echotrail pair`: whom this machine lets in, or goes to.
Command addPairCommand(CLI::App& program);

/// `echotrail fetch`: recordings from a tracker, whole or as they grow.
Command addFetchCommand(CLI::App& program);

/// `echotrail replay`: a recording through the pipeline, tracks out.
Command addReplayCommand(CLI::App& program);

/// `echotrail recover`: what is whole in a damaged log, to a new one.
Command addRecoverCommand(CLI::App& program);

/// `echotrail convert`: exports and imports.
Command addConvertCommand(CLI::App& program);

/// `echotrail evaluate`: how well scenarios or a recording with known truth are tracked.
Command addEvaluateCommand(CLI::App& program);

/// `echotrail info`: what is in a recording.
Command addInfoCommand(CLI::App& program);

/// `echotrail simulate`: a scenario as a recording, or as a head on a port.
Command addSimulateCommand(CLI::App& program);

/// `echotrail tune-enhancement`: the local enhancement for one scenario, by particle swarm.
Command addTuneEnhancementCommand(CLI::App& program);

/// `echotrail verify`: whether a recording gives its tracks again.
Command addVerifyCommand(CLI::App& program);

}  // namespace echotrail
