#pragma once

#include "core/data/region.hpp"
#include "core/data/track.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace echotrail {

/// A look, and a region, as a log keeps them: one JSON object, every number with all the digits that tell it from its
/// neighbours, so that equal texts mean equal bits.
std::string lookText(const TrackLook& look);
std::string regionText(const Region& region);

/// Of whom a look's text is, and how it stood then. None for any other text: it may come from anywhere.
struct LookState {
    int track = 0;
    TrackState state = TrackState::Tentative;
};
std::optional<LookState> lookStateFrom(std::string_view text);

}  // namespace echotrail
