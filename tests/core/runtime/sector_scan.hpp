#pragma once

#include "core/data/source.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace echotrail::test {

/// A head that sweeps ±20° in steps of 2°, 21 pings a sweep, 50 ms a ping, with one bright target that comes nearer.
inline std::vector<Ping> sectorScan(std::uint64_t pings) {
    std::vector<Ping> scan(pings);
    for (std::uint64_t i = 0; i < pings; ++i) {
        const std::uint64_t sweep = i / 21;
        const auto step = static_cast<double>(i % 21);
        Ping& ping = scan[i];
        ping.sequence = i;
        ping.time = Timestamp(std::chrono::seconds(1000)) + i * std::chrono::milliseconds(50);
        ping.bearing = Bearing::degrees(sweep % 2 == 0 ? -20.0 + 2.0 * step : 20.0 - 2.0 * step);
        ping.clockwise = sweep % 2 == 0;
        ping.step_rad = radiansFromDegrees(2.0);
        ping.range_scale_m = 20.0;
        ping.sound_speed_mps = 1500.0;
        ping.bin_interval_s = 2.0 * 20.0 / 400.0 / 1500.0;
        ping.gain_percent = 40.0;
        ping.levels.assign(400, 30);
        const double off_axis = (ping.bearing.inDegrees() - 4.0) / 2.0;
        const double target_bin = 300.0 - 0.1 * static_cast<double>(i);
        for (std::size_t bin = 0; bin < ping.levels.size(); ++bin) {
            const double off_range = (static_cast<double>(bin) - target_bin) / 5.0;
            const double echo = 180.0 * std::exp(-off_axis * off_axis - off_range * off_range);
            ping.levels[bin] = static_cast<std::uint8_t>(30.0 + echo + static_cast<double>((bin * 7 + i * 13) % 11));
        }
    }
    return scan;
}

class ScanSource : public PingSource {
public:
    explicit ScanSource(std::vector<Ping> pings) : pings_(std::move(pings)) {
        info_.name = "sector scan";
        info_.pings = pings_.size();
    }
    std::optional<Ping> next() override {
        if (at_ == pings_.size()) return std::nullopt;
        return pings_[at_++];
    }
    void rewind() override { at_ = 0; }
    const SourceInfo& info() const override { return info_; }
    SourceCounts counts() const override { return {}; }
    const PoseHistory& navigation() const override { return navigation_; }

private:
    std::vector<Ping> pings_;
    std::size_t at_ = 0;
    SourceInfo info_;
    PoseHistory navigation_;
};

/// Fails when it is read the second time, as a file on a drive that was pulled out.
class VanishingSource : public ScanSource {
public:
    using ScanSource::ScanSource;
    std::optional<Ping> next() override {
        if (rewinds_ > 1) throw std::runtime_error("drive removed");
        return ScanSource::next();
    }
    void rewind() override {
        ++rewinds_;
        ScanSource::rewind();
    }

private:
    int rewinds_ = 0;
};

}  // namespace echotrail::test
