#pragma once

#include "app/io/byte_channel.hpp"
#include "core/simulation/simulation_address.hpp"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace echotrail {

/// Where the bytes of a live run come from. A simulated head brings its vehicle's navigation with it.
struct LiveAddresses {
    std::variant<LinkAddress, SimulationAddress> sonar;
    std::optional<LinkAddress> navigation;  ///< of a real head; none where none was asked for

    bool isSimulated() const { return std::holds_alternative<SimulationAddress>(sonar); }
    bool hasNavigation() const { return isSimulated() || navigation; }
    /// As they are typed.
    std::string sonarText() const;
    std::string navigationText() const;
};

/// Reads both as typed, `navigation` possibly empty. The error, a matter of usage, says which and what would be
/// accepted.
Result<LiveAddresses> parseLiveAddresses(const std::string& sonar, const std::string& navigation);

/// The links of a live run, closed; `navigation` only where there is one.
struct LiveChannels {
    std::unique_ptr<ByteChannel> sonar, navigation;
};

/// To the devices at the addresses; or a device of this very program, which begins when the sonar's link is opened and
/// ends with both links.
LiveChannels makeChannels(const LiveAddresses& addresses);

}  // namespace echotrail
