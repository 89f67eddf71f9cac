#include "core/simulation/scan_motion.hpp"

#include <algorithm>

namespace echotrail {
namespace {

int wrapped(int units) {
    constexpr int turn = ScanMotion::turn_units;
    return ((units % turn) + turn) % turn;
}

}  // namespace

int ScanMotion::end() const {
    const Sector s = sector();
    if (limits_.continuous || s.first == s.last) return 0;
    const int offset = offsetIn(s);
    return offset == s.first ? -1 : offset == s.last ? 1 : 0;
}

ScanMotion::Sector ScanMotion::sector() const {
    const int left = limits_.left, step = limits_.step, width = wrapped(limits_.right - left);
    if (limits_.stare || width == 0) return {left, 0, 0};
    if (digital_) return {left, 0, width};
    return {left, left / step * step - left, (left + width) / step * step - left};
}

int ScanMotion::offsetIn(const Sector& s) const {
    const int offset = wrapped(position_ - s.left);
    return offset - turn_units >= s.first ? offset - turn_units : offset;
}

int ScanMotion::moveTo(int position) {
    const int way = wrapped(position - position_);
    position_ = wrapped(position);
    return std::min(way, turn_units - way);
}

int ScanMotion::enter() {
    if (limits_.continuous) return 0;
    const Sector s = sector();
    const int step = limits_.step;
    int offset = offsetIn(s);
    if (offset > s.last) offset = offset - s.last < turn_units + s.first - offset ? s.last : s.first;
    if (offset != s.first) offset = std::max(s.last - (s.last - offset + step / 2) / step * step, s.first);
    const int way = moveTo(s.left + offset);
    if (digital_) reverseAtLimit(s);
    return way;
}

int ScanMotion::step() {
    const int step = limits_.step;
    if (limits_.continuous) return moveTo(position_ + (clockwise_ ? step : -step));
    const Sector s = sector();
    const int offset = offsetIn(s);
    if (!digital_ && offset == (clockwise_ ? s.last : s.first)) {
        if (s.first != s.last) clockwise_ = !clockwise_;
        return 0;
    }
    // Steps count from the last bearing: only the one next to the first may be shorter.
    const int short_step = (s.last - offset) % step;
    const int next = clockwise_ ? offset + (short_step ? short_step : step) : offset - step;
    const int way = moveTo(s.left + std::clamp(next, s.first, s.last));
    if (digital_) reverseAtLimit(s);
    return way;
}

/// Digital heads tell the new direction with the line at the limit itself.
void ScanMotion::reverseAtLimit(const Sector& s) {
    if (s.first == s.last) return;
    if (offsetIn(s) == s.first) clockwise_ = true;
    if (offsetIn(s) == s.last) clockwise_ = false;
}

}  // namespace echotrail
