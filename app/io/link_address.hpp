#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace echotrail {

/// Where a live device is reached, or where one is waited for.
struct LinkAddress {
    enum class Kind { Serial, Tcp, Udp, PseudoTerminal, Tls };
    Kind kind = Kind::Tcp;
    std::string device;  ///< of a serial port
    int baud = 115'200;
    std::string host;
    std::uint16_t port = 0;    ///< to listen on: 0 is any free one
    std::uint16_t listen = 0;  ///< UDP: where answers are expected; 0 is any free one
    std::string format;        ///< of a report: "json" or "nmea"
    double rate_hz = 0.0;      ///< of a report, how often; 0: as usual
    bool operator==(const LinkAddress&) const = default;
};

/// Whether a text names a live link (serial, tcp, tls, udp or pty) rather than a file or a scenario.
bool isLinkAddress(const std::string& text);

/// Reads `serial:///dev/ttyUSB0?baud=115200`, `tcp://HOST:PORT`, `udp://HOST:PORT?listen=PORT` (an IPv6 host in
/// brackets), `pty`, or `tls://HOST:PORT`, where a tracker is, and never a device. The error, a matter of usage, says
/// what would be accepted.
Result<LinkAddress> parseLinkAddress(const std::string& text);

/// The same of an option that may be left out; the error names the option.
Result<std::optional<LinkAddress>> parseLinkOption(const std::string& option, const std::string& text);

/// Where a tracker serves consoles: tls, or tcp on this machine. The error, a matter of usage, says what would be
/// accepted.
Result<LinkAddress> parseTrackerAddress(const std::string& text);

/// As it is typed.
std::string toText(const LinkAddress& address);

}  // namespace echotrail
