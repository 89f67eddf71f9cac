#include "core/data/track.hpp"

#include <array>

namespace echotrail {

std::string_view toText(TrackState state) {
    constexpr std::array<std::string_view, 4> names{"tentative", "confirmed", "coasting", "lost"};
    return names[static_cast<std::size_t>(state)];
}

}  // namespace echotrail
