#include "core/data/track.hpp"

#include <array>

namespace echotrail {

std::string_view toText(TrackState state) {
    constexpr std::array<std::string_view, 4> names{"tentative", "confirmed", "coasting", "lost"};
    return names[static_cast<std::size_t>(state)];
}

std::string_view toText(NoEcho cause) {
    constexpr std::array<std::string_view, no_echo_causes> names{"",
                                                                 "outside the sector",
                                                                 "not yet scanned",
                                                                 "under the threshold",
                                                                 "merged with clutter",
                                                                 "taken by another track",
                                                                 "out-scored by clutter",
                                                                 "navigation gap",
                                                                 "pings missing"};
    return names[static_cast<std::size_t>(cause)];
}

}  // namespace echotrail
