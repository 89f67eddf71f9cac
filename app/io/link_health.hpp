#pragma once

#include "app/io/head_link.hpp"
#include "core/link/link_values.hpp"

namespace echotrail {

/// How a live run is, as it is told to consoles.
LinkHealth linkHealth(const HeadLinkState& link, const LiveStatus& run, Timestamp now);

/// The same put back into what a live run at this console would say of itself.
seanet::HeadStatus headStatusFrom(const LinkHealth& health, const HeadSettings& commanded);
LiveStatus liveStatusFrom(const LinkHealth& health);

}  // namespace echotrail
