#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace echotrail {

/// Counter-based random numbers (Philox4x32-10, Salmon et al. 2011): a stream is named by its seed and two words
/// that say what it is for, so any stream can be drawn at any time, in any order and on any thread, with the same
/// result. The Gaussian transform is ours because std::normal_distribution differs between libraries.
class RandomStream {
public:
    /// E.g. RandomStream(seed, track_id, update_number).
    RandomStream(std::uint64_t seed, std::uint64_t purpose, std::uint64_t index);

    std::uint32_t bits();
    /// Uniform in (0, 1): never 0, never 1.
    double uniform();
    /// Zero mean, unit variance (Box–Muller).
    double gaussian();
    /// Many Gaussian numbers at once, in single precision and fast: from whole blocks of 256 after those begun, so
    /// that a call takes ceil(size / 256) of them. Not the numbers that gaussian() would give.
    void fillGaussian(std::span<float> out);

private:
    void refill();
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> block_{};
    int used_ = 4;
    double spare_ = 0.0;
    bool has_spare_ = false;
};

}  // namespace echotrail
