#pragma once

#include "core/navigation/sentences.hpp"

namespace echotrail {

struct LocalPosition {
    double north_m = 0.0;
    double east_m = 0.0;
};

/// The plane that touches the WGS-84 ellipsoid at its origin, with axes north and east there. A position is carried
/// by its earth-centred coordinates (the standard geodetic conversion at height 0), so there is no error of
/// approximation: only the earth's curvature, which shortens 10 km by 4 mm.
class LocalPlane {
public:
    explicit LocalPlane(const GeographicPosition& origin) : origin_(origin) {}
    LocalPosition toLocal(const GeographicPosition& position) const;

private:
    GeographicPosition origin_;
};

}  // namespace echotrail
