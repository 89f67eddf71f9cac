#pragma once

#include "ui/style/echo_map.hpp"

namespace echotrail {

/// What of a scene is shown.
struct Layers {
    bool echoes = true;
    bool enhanced = false;  ///< the locally enhanced picture instead of the plain one
    bool regions_kept = true;
    bool regions_dropped = true;
    bool particles = true;
    bool tracks = true;  ///< symbols and labels
    bool ellipses = true;
    bool history = true;  ///< where it was and where it is expected
    bool region_of_interest = true;
    bool guard_zones = true;
    bool vetoes = true;
    bool marks = true;
    bool trails = false;  ///< where something moved during the last minute
    bool moving = false;  ///< without what earlier sweeps show at the same place, instead of the plain picture
    bool graticule = true;
    bool inset = true;  ///< the target four times as large
    bool operator==(const Layers&) const = default;
};

/// How echo levels are shown.
struct EchoSettings {
    EchoMap map = EchoMap::Grey;
    double black_db = 5.0;   ///< this level and below is the map's first colour
    double white_db = 50.0;  ///< this level and above is its last
    double fade = 0.38;      ///< darkening of the oldest beam, 0…0.38
    bool operator==(const EchoSettings&) const = default;
};

inline constexpr double most_fade = 0.38;
inline constexpr double trail_s = 60.0;  ///< after so long a trail has faded away

enum class Orientation { HeadUp, NorthUp, CourseUp };

}  // namespace echotrail
