#pragma once

#include <bitset>
#include <cstdint>

namespace echotrail {

/// Tells numbers that have not come before from those that have, or that are too old to be told apart (RFC
/// 4303, 3.4.3). Order: accept() only what is known to come from the sender.
class ReplayWindow {
public:
    static constexpr std::uint64_t width = 1024;

    /// Whether the number is new; from then on it is not. Numbers count from 1.
    bool accept(std::uint64_t number) {
        if (number == 0 || (newest_ >= width && number <= newest_ - width)) return false;
        if (number > newest_) {
            if (number - newest_ >= width)
                seen_.reset();
            else
                for (std::uint64_t passed = newest_ + 1; passed <= number; ++passed) seen_.reset(passed % width);
            newest_ = number;
        }
        if (seen_.test(number % width)) return false;
        seen_.set(number % width);
        return true;
    }
    std::uint64_t newest() const { return newest_; }

private:
    std::bitset<width> seen_;
    std::uint64_t newest_ = 0;
};

}  // namespace echotrail
