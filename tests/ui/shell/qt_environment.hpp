#pragma once

#include "tests/core/runtime/sector_scan.hpp"
#include "ui/bridge/source_opener.hpp"

#include <functional>
#include <memory>
#include <string>

namespace echotrail::test {

/// Lets Qt work until `done`, or for a minute: then the test fails, for what it waits for never comes.
bool await(const std::function<bool()>& done);

/// What opens a simulated sector scan of so many pings.
inline SourceOpener::Opener scanOpener(std::uint64_t pings) {
    return [pings]() -> SourceOpener::Outcome {
        return std::unique_ptr<PingSource>(std::make_unique<ScanSource>(sectorScan(pings)));
    };
}

}  // namespace echotrail::test
