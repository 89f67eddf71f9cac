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
    /// `at`: local coordinates of the origin.
    explicit LocalPlane(const GeographicPosition& origin, const LocalPosition& at = {}) : origin_(origin), at_(at) {}
    LocalPosition toLocal(const GeographicPosition& position) const;
    /// The other way round, to less than a millimetre within 100 km; away from the poles.
    GeographicPosition toGeographic(const LocalPosition& place) const;

private:
    GeographicPosition origin_;
    LocalPosition at_;
};

}  // namespace echotrail
