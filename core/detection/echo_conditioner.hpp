#pragma once

#include "core/base/parameters.hpp"
#include "core/data/ping.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace echotrail {

/// One echo line made ready for detection: range cells of 1/400 of the line (or single bins, if there are fewer),
/// each with its level and the background it stands out from. Units: 1/255 of 80 dB. Cell i is centred at
/// (i + 1/2) * cell_m.
struct EchoRow {
    double cell_m = 0.0;
    std::vector<std::uint8_t> level;   ///< mean of the cell's bins
    std::vector<std::uint8_t> smooth;  ///< level, smoothed along the line
    std::vector<std::uint8_t> background;
};

struct EchoConditionerParams {
    double background_window_percent = 35.0;
    bool remove_rings = true;
};

template <>
struct Described<EchoConditionerParams> {
    static constexpr std::string_view group = "Background";
    static constexpr auto fields = std::tuple{
        Field{&EchoConditionerParams::background_window_percent, "background_window_percent", "% of range", 4, 100,
              "Length of the stretch of the echo line whose median is the background"},
        flag(&EchoConditionerParams::remove_rings, "remove_rings",
             "Count what every bearing shows at the same range (ring-down, the head's own noise) as background")};
};

/// Turns pings into echo rows.
/// The background is the median along the echo line, not over a square of the picture: another sounder fills a
/// line, and would otherwise look like a bright target. Where every bearing shows the same at a range, that is
/// background too (a slowly followed median over bearings): it takes out the ring-down after transmission.
/// Order: pings in time order. State: the median over bearings.
class EchoConditioner {
public:
    static constexpr int max_cells = 400;

    explicit EchoConditioner(const EchoConditionerParams& params) : params_(params) {}
    void setParams(const EchoConditionerParams& params) { params_ = params; }

    void condition(const Ping& ping, EchoRow& row);

private:
    void followRings(EchoRow& row);

    EchoConditionerParams params_;
    std::vector<std::uint32_t> sums_;   ///< running sums of the bins, one more than there are bins
    std::vector<std::uint8_t> coarse_;  ///< every fourth cell's mean
    std::vector<std::uint8_t> coarse_median_;
    std::vector<std::int16_t> ring_;  ///< median over bearings, in 1/16 level
    double ring_cell_m_ = 0.0;
    int pings_ = 0;
};

/// The median of the `window` values about each value (fewer at the ends): a histogram slides along.
void runningMedian(std::span<const std::uint8_t> values, int window, std::span<std::uint8_t> medians);

}  // namespace echotrail
