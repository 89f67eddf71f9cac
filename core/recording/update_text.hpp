#pragma once

#include "core/data/region.hpp"
#include "core/data/track.hpp"

#include <string>

namespace echotrail {

/// A look, and a region, as a log keeps them: one JSON object, every number with all the digits that tell it from its
/// neighbours, so that equal texts mean equal bits.
std::string lookText(const TrackLook& look);
std::string regionText(const Region& region);

}  // namespace echotrail
