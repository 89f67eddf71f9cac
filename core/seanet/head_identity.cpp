#include "core/seanet/head_configuration.hpp"

#include <array>
#include <cmath>
#include <sstream>

namespace echotrail::seanet {
namespace {

/// Codes of the frequencies in mtVersionData of old heads, in kHz (DigSon notes and a SeaKing's own reply).
double codedKilohertz(int code) {
    constexpr std::array<double, 13> khz{0, 325, 580, 675, 795, 935, 1210, 200, 1700, 2000, 500, 1500, 295};
    return code < static_cast<int>(khz.size()) ? khz[static_cast<std::size_t>(code)] : 0.0;
}

/// There is no checksum: damage must not make a command of nonsense.
bool isPlausible(double hz) { return hz >= 50e3 && hz <= 5e6; }

std::string modelOf(const HeadIdentity& head) {
    if (!head.digital()) return head.twoChannels() ? "SeaKing DFS" : "SeaPrince or MiniKing";
    switch (head.block ? head.block->head_kind : 0) {
        case 1:
            return "SeaKing DST";
        case 2:
            return "SeaPrince DST";
        case 3:
            return "Micron DST";
        default:
            return "digital head";
    }
}

}  // namespace

bool HeadIdentity::digital() const {
    constexpr std::uint8_t digital_type = 0x11;
    return block ? block->digital() : device_type == digital_type;
}

double HeadIdentity::frequencyHz(std::size_t channel) const {
    if (block && block->digital()) {
        const DigitalChannel& band = block->channel[channel];
        const double middle = (static_cast<double>(band.transmit_start_hz) + band.transmit_end_hz) / 2.0;
        if (isPlausible(middle)) return middle;
        return channel == 0 ? 700e3 : 0.0;  // a Micron's
    }
    if (digital()) return channel == 0 ? 700e3 : 0.0;  // a Micron's
    std::array<double, 2> khz{325.0, 675.0};           // a SeaKing's, where the head does not tell
    if (block && isPlausible(block->transmit_khz[0] * 1000.0))
        khz = {static_cast<double>(block->transmit_khz[0]), static_cast<double>(block->transmit_khz[1])};
    else if (version && codedKilohertz(version->byte13 & 0x0F) > 0.0)
        khz = {codedKilohertz(version->byte13 & 0x0F), codedKilohertz(version->byte13 >> 4)};
    if (channel == 1 && (khz[1] == khz[0] || !isPlausible(khz[1] * 1000.0)))
        return 0.0;  // heads of one channel tell it twice
    return khz[channel] * 1000.0;
}

std::string HeadIdentity::text() const {
    if (!version && !block) return {};
    std::ostringstream text;
    text << modelOf(*this);
    if (version && version->serial != 0) text << ", serial " << version->serial;
    text << ", node " << static_cast<int>(node) << ", " << std::lround(frequencyHz(0) / 1000.0);
    if (twoChannels()) text << '/' << std::lround(frequencyHz(1) / 1000.0);
    text << " kHz";
    return text.str();
}

}  // namespace echotrail::seanet
