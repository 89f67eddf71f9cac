#include "core/base/random.hpp"

#include <algorithm>
#include <bit>
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

/// ln u for 0 < u ≤ 1: u = m·2^e with m in [√½, √2), ln m = 2 artanh((m − 1)/(m + 1)) by its series, to 3e-8.
inline float logOf(float u) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(u) - 0x3F3504F3U;  // less the bits of √½
    const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits) >> 23);
    const float m = std::bit_cast<float>((bits & 0x007FFFFFU) + 0x3F3504F3U);
    const float s = (m - 1.0F) / (m + 1.0F), q = s * s;
    return exponent * std::numbers::ln2_v<float> + 2.0F * s * (1.0F + q * (1.0F / 3 + q * (1.0F / 5 + q * (1.0F / 7))));
}

/// Two Gaussian numbers from two words (Box–Muller) in single precision, with no branch, so that a loop of it becomes
/// vector instructions; only + − × / √ are used, so that every build gives the same bits. The radius comes from the
/// upper 24 bits of one word: no number is beyond 5.9.
inline void gaussianPair(std::uint32_t radius_word, std::uint32_t angle_word, float& first, float& second) {
    const float u = (static_cast<float>(static_cast<std::int32_t>(radius_word >> 8)) + 0.5F) * 0x1p-24F;
    const float radius = std::sqrt(std::max(-2.0F * logOf(u), 0.0F));
    // Angle as a quarter turn and a rest of at most an eighth, whose sine and cosine are short series.
    const std::uint32_t quarter = (angle_word + 0x20000000U) >> 30;
    const auto rest = static_cast<std::int32_t>(angle_word - (quarter << 30));
    const float a = static_cast<float>(rest) * (2.0F * std::numbers::pi_v<float> * 0x1p-32F), q = a * a;
    const float sine = a * (1.0F - q * (1.0F / 6 - q * (1.0F / 120 - q * (1.0F / 5040 - q * (1.0F / 362880)))));
    const float cosine = 1.0F - q * (1.0F / 2 - q * (1.0F / 24 - q * (1.0F / 720 - q * (1.0F / 40320))));
    const auto sine_bits = std::bit_cast<std::uint32_t>(sine), cosine_bits = std::bit_cast<std::uint32_t>(cosine);
    const std::uint32_t swapped = 0U - (quarter & 1U);
    const std::uint32_t x = (cosine_bits & ~swapped) | (sine_bits & swapped);
    const std::uint32_t y = (sine_bits & ~swapped) | (cosine_bits & swapped);
    first = radius * std::bit_cast<float>(x ^ (((quarter + 1U) & 2U) << 30));
    second = radius * std::bit_cast<float>(y ^ ((quarter & 2U) << 30));
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
    constexpr std::size_t blocks = 64;  // at a time: one array per word, as vector instructions want it
    std::array<std::array<std::uint32_t, blocks>, 4> words;
    std::array<std::array<float, blocks>, 4> numbers;
    while (!out.empty()) {
        for (std::uint32_t i = 0; i < blocks; ++i) {
            const auto block = philox({counter_[0] + i, counter_[1], counter_[2], counter_[3]}, key_);
            for (std::size_t w = 0; w < 4; ++w) words[w][i] = block[w];
        }
        for (std::size_t half = 0; half < 4; half += 2)
            for (std::size_t i = 0; i < blocks; ++i)
                gaussianPair(words[half][i], words[half + 1][i], numbers[half][i], numbers[half + 1][i]);
        std::size_t taken = 0;
        for (std::size_t w = 0; w < 4 && taken < out.size(); ++w) {
            const std::size_t part = std::min(blocks, out.size() - taken);
            std::copy_n(numbers[w].begin(), part, out.begin() + static_cast<std::ptrdiff_t>(taken));
            taken += part;
        }
        counter_[0] += blocks;
        out = out.subspan(taken);
    }
}

}  // namespace echotrail
