#pragma once

#include "core/base/angles.hpp"
#include "core/base/result.hpp"
#include "core/navigation/nmea.hpp"

namespace echotrail {

/// What the sentences of NMEA 0183 say that a pose is made of. Field orders are those of the standard, version 4.10.
/// Every reader expects a sentence of the kind it names; the error is one of `nmea_cause`.

struct HeadingReading {
    Bearing heading;        ///< from true north, or from magnetic north
    bool magnetic = false;  ///< no variation was given
};

/// HDT (true), or HDG (sensor heading with deviation and variation, each added where given, east positive).
Result<HeadingReading> readHeading(const NmeaSentence& sentence);

/// On the WGS-84 ellipsoid.
struct GeographicPosition {
    double latitude_rad = 0.0;   ///< north positive
    double longitude_rad = 0.0;  ///< east positive
};

/// RMC or GGA; `not_valid` where the receiver had no fix.
Result<GeographicPosition> readPosition(const NmeaSentence& sentence);

/// A velocity over ground in m/s: north and east (VTG), or along and across the vehicle (VBW).
struct GroundVelocity {
    double north_or_ahead_mps = 0.0;
    double east_or_starboard_mps = 0.0;
    bool along_vehicle = false;
};

/// VTG or VBW; `not_valid` where the instrument had no speed over ground (VBW may have one through water only).
Result<GroundVelocity> readVelocity(const NmeaSentence& sentence);

/// DPT or DBT: metres of water below the transducer.
Result<double> readDepth(const NmeaSentence& sentence);

}  // namespace echotrail
