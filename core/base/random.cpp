#include "core/base/random.hpp"

#include <cmath>
#include <numbers>

namespace echotrail {

namespace {

/// Ten rounds of Philox4x32 with the constants of Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", 2011.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> k) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t p0 = std::uint64_t{0xD2511F53} * c[0];
        const std::uint64_t p1 = std::uint64_t{0xCD9E8D57} * c[2];
        c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(p1),
             static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(p0)};
        k[0] += 0x9E3779B9;
        k[1] += 0xBB67AE85;
    }
    return c;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t purpose, std::uint64_t index)
    : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, static_cast<std::uint32_t>(purpose), static_cast<std::uint32_t>(index),
               static_cast<std::uint32_t>((purpose >> 32) ^ ((index >> 32) << 16))} {}

void RandomStream::refill() {
    block_ = philox(counter_, key_);
    ++counter_[0];
    used_ = 0;
}

std::uint32_t RandomStream::bits() {
    if (used_ == 4) refill();
    return block_[used_++];
}

double RandomStream::uniform() { return (bits() + 0.5) * 0x1p-32; }

double RandomStream::gaussian() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
}

void RandomStream::fillGaussian(std::span<float> out) {
    for (float& value : out) value = static_cast<float>(gaussian());
}

}  // namespace echotrail
