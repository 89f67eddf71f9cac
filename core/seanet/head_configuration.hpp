#pragma once

#include "core/data/head_settings.hpp"
#include "core/seanet/commands.hpp"
#include "core/seanet/head_data.hpp"
#include "core/seanet/messages.hpp"

#include <cstdint>
#include <optional>
#include <string>

/// From what an operator wants to what a head is told, and back from what it says. Formulas: Tritech DigSon notes and
/// the settings that the maker's program stores.
namespace echotrail::seanet {

/// What a head has said of itself. Old heads tell their frequencies in both replies, digital ones in the block only.
struct HeadIdentity {
    std::optional<VersionData> version;
    std::optional<BBUserData> block;
    std::uint8_t device_type = 0;  ///< of a line it sent; 0: none yet
    std::uint8_t node = default_head_node;

    bool digital() const;
    /// Without its word on it a head is taken to share two wires: that is slower, but always works.
    bool halfDuplex() const { return !block || block->half_duplex; }
    /// Middle of the band of channel 0 or 1; 0 where there is no such channel.
    double frequencyHz(std::size_t channel) const;
    bool twoChannels() const { return frequencyHz(1) > 0.0; }
    /// "SeaKing DFS, serial 123, node 2, 325/675 kHz".
    std::string text() const;
};

/// The parameters that make this head do what the settings say, as nearly as its units allow.
HeadCommand commandFor(const HeadSettings& settings, const HeadIdentity& head);
/// The part of commandFor() that the short form carries.
ChannelGains gainsFor(const HeadSettings& settings, const HeadIdentity& head);
/// True where the short form is enough to bring the head from one set of parameters to the other.
bool differOnlyInGains(const HeadCommand& a, const HeadCommand& b);

/// Empty where the head's own copy confirms the command; otherwise the first difference, for a person to read. What
/// heads round or change by themselves (bin interval, bins, direction) may differ by as much as they do that.
std::string differenceOf(const HeadCommand& commanded, const HeadData& reply);

/// What the head does by its own copy; what it does not know (mounting, sound speed) is as in `ours`.
HeadSettings confirmedSettings(const HeadData& reply, const HeadSettings& ours);

}  // namespace echotrail::seanet
