#pragma once

#include "core/base/result.hpp"
#include "core/data/source.hpp"
#include "core/recording/recording.hpp"
#include "core/simulation/simulation_address.hpp"

#include <memory>
#include <optional>
#include <string>

namespace echotrail {

/// A SOURCE of the command line that can be read from its beginning to its end: a recording or a built-in scenario.
struct SourceAddress {
    std::string path;  ///< of a recording; empty for a scenario
    std::optional<SimulationAddress> simulation;
};

/// Reads a path or `simulation://NAME?seed=N`. The error, a matter of usage, says what would be accepted; live forms
/// (serial, tcp, udp) are among what is not.
Result<SourceAddress> parseSourceAddress(const std::string& text);

Result<std::unique_ptr<PingSource>> openSource(const SourceAddress& address, const RecordingOptions& options);

}  // namespace echotrail
