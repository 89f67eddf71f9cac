#pragma once

namespace echotrail {

/// The way of a head's transducer to and fro over its sector, in the head's own units of 1/16 gradian (6400 a turn;
/// 3200 is ahead), as captures show it: a digital head counts its steps from the right limit and reaches both; an old
/// one keeps to multiples of its step, so may pass the left limit, and stays at either end for two lines.
class ScanMotion {
public:
    static constexpr int turn_units = 6400, ahead_units = 3200;

    struct Limits {
        int left = 1840, right = 4560;  ///< 0…6399, clockwise from left to right; the same: it stays there
        int step = 32;                  ///< 1…255
        bool continuous = false;        ///< round and round instead
        bool stare = false;             ///< stays at the left limit
    };

    explicit ScanMotion(bool digital) : digital_(digital) {}

    int position() const { return position_; }
    bool clockwise() const { return clockwise_; }
    void setClockwise(bool clockwise) { clockwise_ = clockwise; }
    /// Which end of a sector it is at: -1 the left one, 1 the right one, 0 neither or no sector.
    int end() const;

    /// Back to ahead.
    void centre() { position_ = ahead_units; }
    /// The way to come; the transducer stays where it is until it is moved.
    void setLimits(const Limits& limits) { limits_ = limits; }
    /// Moves to where the new way begins: the nearest bearing on it. Gives how many units it turned, as step() does.
    int enter();
    /// Moves to the next bearing of the way.
    int step();

private:
    /// The way between two bearings, in units from the left limit.
    struct Sector {
        int left = 0, first = 0, last = 0;
    };
    Sector sector() const;
    int offsetIn(const Sector& sector) const;
    int moveTo(int position);
    void reverseAtLimit(const Sector& sector);

    bool digital_;
    Limits limits_;
    int position_ = ahead_units;
    bool clockwise_ = true;
};

}  // namespace echotrail
