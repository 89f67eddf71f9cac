#pragma once

#include "core/data/scan_sector.hpp"
#include "core/simulation/scan_motion.hpp"
#include "core/simulation/scenario.hpp"

#include <cstdint>

namespace echotrail {

/// Which way a scenario's head looks at each of its transmissions where it is told what to scan: as one on a port is
/// (SimulatedHead), without the bytes. It begins with the scenario's own sector, and takes a new one when the
/// transmission that is under way by then is over. Where its motor has further to turn than a step, transmissions are
/// left out until it is there.
/// Order: next() for each transmission; command() in between.
class CommandedScan {
public:
    explicit CommandedScan(const Scenario& scenario);

    struct Look {
        std::uint64_t number = 0;  ///< of the transmission, as pingTime() counts
        Bearing bearing;           ///< of the beam, from the bow
        bool clockwise = true;
    };
    Look next();
    /// The number of the look that next() will give; a command does not change it any more.
    std::uint64_t upcoming() const { return number_; }
    void command(const ScanSector& sector) { commanded_ = sector; }

private:
    static ScanMotion::Limits limitsOf(const ScanSector& sector, int step);

    double interval_s_;
    int step_;
    ScanMotion motion_{true};
    ScanSector sector_, commanded_;
    std::uint64_t number_ = 0;
};

/// The sector that the scenario itself scans.
ScanSector scanSector(const Scenario& scenario);

}  // namespace echotrail
