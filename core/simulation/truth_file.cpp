#include "core/simulation/truth_file.hpp"

#include <array>
#include <cassert>
#include <charconv>

namespace echotrail {

namespace {

/// Appends a number with a decimal point, whatever the locale, and a comma.
void append(std::string& line, double number, int decimals) {
    std::array<char, 64> text{};
    const auto done = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, decimals);
    assert(done.ec == std::errc());
    line.append(text.data(), done.ptr);
    line += ',';
}

/// `columns` appends what is between the target's number and `visible`.
template <class Columns>
std::string csv(const SimulatedSource& source, std::string_view names, const Columns& columns) {
    std::string text = "t,target,";
    text.append(names).append(",visible\n");
    for (const TruthSample& sample : source.truth()) {
        append(text, secondsBetween(source.info().start, sample.time), 6);
        text += std::to_string(sample.target) + ',';
        columns(text, sample);
        text += sample.visible ? "1\n" : "0\n";
    }
    return text;
}

}  // namespace

std::string truthCsv(const SimulatedSource& source) {
    return csv(source, "north_m,east_m,velocity_north_mps,velocity_east_mps",
               [](std::string& text, const TruthSample& sample) {
                   append(text, sample.north_m, 4);
                   append(text, sample.east_m, 4);
                   append(text, sample.velocity_north_mps, 4);
                   append(text, sample.velocity_east_mps, 4);
               });
}

std::string truthFromHeadCsv(const SimulatedSource& source) {
    return csv(source, "range_m,bearing_deg", [](std::string& text, const TruthSample& sample) {
        append(text, sample.range_m, 4);
        append(text, sample.from_bow.inDegrees(), 4);
    });
}

}  // namespace echotrail
