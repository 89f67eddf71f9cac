#include "app/io/link_address.hpp"

#include <QHostAddress>
#include <algorithm>
#include <array>
#include <charconv>

namespace echotrail {
namespace {

constexpr double slowest_report_hz = 0.1, fastest_report_hz = 50.0;

std::optional<int> numberIn(std::string_view text, int least, int most) {
    int value = 0;
    const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || stop != text.data() + text.size() || value < least || value > most)
        return std::nullopt;
    return value;
}

/// The shortest text that reads back to the same.
std::string numberText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

Error refused(const std::string& text) {
    return Error{"'" + text +
                 "' is no address of a device; say serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or "
                 "udp://HOST:PORT?listen=PORT"};
}

/// The options after '?', as in "baud=9600&format=nmea".
Result<void> readOptions(std::string_view options, LinkAddress& address) {
    while (!options.empty()) {
        const std::string_view option = options.substr(0, options.find('&'));
        options.remove_prefix(std::min(options.size(), option.size() + 1));
        const auto equals = option.find('=');
        const std::string_view name = option.substr(0, equals);
        const std::string_view value = equals == std::string_view::npos ? "" : option.substr(equals + 1);
        const bool serial = address.kind == LinkAddress::Kind::Serial;
        if (name == "baud" && serial) {
            const auto baud = numberIn(value, 1'200, 4'000'000);
            if (!baud) return Error{"baud=" + std::string(value) + " is no baud rate, as in baud=115200"};
            address.baud = *baud;
        } else if (name == "listen" && address.kind == LinkAddress::Kind::Udp) {
            const auto port = numberIn(value, 0, 65'535);
            if (!port) return Error{"listen=" + std::string(value) + " is no port, 0 to 65535"};
            address.listen = static_cast<std::uint16_t>(*port);
        } else if (name == "format" && !serial && address.kind != LinkAddress::Kind::Tls &&
                   (value == "json" || value == "nmea")) {
            address.format = value;
        } else if (name == "rate" && !serial && address.kind != LinkAddress::Kind::Tls) {
            double rate_hz = 0.0;
            const auto [stop, failure] = std::from_chars(value.data(), value.data() + value.size(), rate_hz);
            const bool read = failure == std::errc() && stop == value.data() + value.size();
            if (!read || !(rate_hz >= slowest_report_hz && rate_hz <= fastest_report_hz))
                return Error{"rate=" + std::string(value) + " is no rate of reports, 0.1 to 50 a second"};
            address.rate_hz = rate_hz;
        } else {
            return Error{"the option " + std::string(option) + " is not understood"};
        }
    }
    return {};
}

}  // namespace

bool isLinkAddress(const std::string& text) {
    return text == "pty" || text.starts_with("serial://") || text.starts_with("tcp://") || text.starts_with("tls://") ||
           text.starts_with("udp://");
}

Result<LinkAddress> parseLinkAddress(const std::string& text) {
    LinkAddress address;
    if (text == "pty") {
        address.kind = LinkAddress::Kind::PseudoTerminal;
        return address;
    }
    if (!isLinkAddress(text)) return refused(text);
    address.kind = text.starts_with("serial") ? LinkAddress::Kind::Serial
                   : text.starts_with("tcp")  ? LinkAddress::Kind::Tcp
                   : text.starts_with("tls")  ? LinkAddress::Kind::Tls
                                              : LinkAddress::Kind::Udp;
    std::string rest = text.substr(text.find("://") + 3);
    const auto question = rest.find('?');
    if (question != std::string::npos) {
        const std::string options = rest.substr(question + 1);
        rest.resize(question);
        if (auto read = readOptions(options, address); !read) return Error{text + ": " + read.error()};
    }
    if (address.kind == LinkAddress::Kind::Serial) {
        if (rest.size() < 2 || rest[0] != '/') return refused(text);
        address.device = rest;
        return address;
    }
    const auto colon = rest.rfind(':');
    if (colon == std::string::npos || colon == 0) return refused(text);
    const auto port = numberIn(std::string_view(rest).substr(colon + 1), 0, 65'535);
    if (!port) return refused(text);
    address.host = rest.substr(0, colon);
    const bool bracketed = address.host.front() == '[' && address.host.back() == ']';
    if (bracketed) address.host = address.host.substr(1, address.host.size() - 2);
    if (address.host.empty() || address.host.find_first_of(bracketed ? " /[]" : " /[]:") != std::string::npos)
        return refused(text);
    address.port = static_cast<std::uint16_t>(*port);
    return address;
}

Result<std::optional<LinkAddress>> parseLinkOption(const std::string& option, const std::string& text) {
    if (text.empty()) return std::optional<LinkAddress>();
    auto address = parseLinkAddress(text);
    if (!address) return Error{option + ": " + address.error()};
    return std::optional(*std::move(address));
}

Result<LinkAddress> parseTrackerAddress(const std::string& text) {
    const std::string forms = "say tls://HOST:PORT, or tcp://127.0.0.1:PORT on this machine";
    auto parsed = parseLinkAddress(text);
    if (!parsed) return Error{"'" + text + "' is no address of a tracker; " + forms};
    const bool plain = parsed->kind == LinkAddress::Kind::Tcp;
    if ((!plain && parsed->kind != LinkAddress::Kind::Tls) || parsed->port == 0)
        return Error{text + ": a tracker is not reached so; " + forms};
    const QString host = QString::fromStdString(parsed->host);
    if (plain && host != "localhost" && !QHostAddress(host).isLoopback())
        return Error{text + ": plain TCP does not leave this machine; pair with echotrail pair, and " + forms};
    return parsed;
}

std::string toText(const LinkAddress& address) {
    const bool bracketed = address.host.find(':') != std::string::npos;
    const std::string where =
        (bracketed ? "[" + address.host + "]" : address.host) + ":" + std::to_string(address.port);
    std::string options;
    if (address.listen != 0) options = "?listen=" + std::to_string(address.listen);
    if (!address.format.empty()) options += (options.empty() ? "?format=" : "&format=") + address.format;
    if (address.rate_hz > 0.0) options += (options.empty() ? "?rate=" : "&rate=") + numberText(address.rate_hz);
    switch (address.kind) {
        case LinkAddress::Kind::Serial:
            return "serial://" + address.device + "?baud=" + std::to_string(address.baud);
        case LinkAddress::Kind::Tcp:
            return "tcp://" + where + options;
        case LinkAddress::Kind::Tls:
            return "tls://" + where;
        case LinkAddress::Kind::Udp:
            return "udp://" + where + options;
        case LinkAddress::Kind::PseudoTerminal:
            break;
    }
    return "pty";
}

}  // namespace echotrail
