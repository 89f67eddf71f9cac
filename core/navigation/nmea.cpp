#include "core/navigation/nmea.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace echotrail {
namespace {

Error rejected(std::string_view cause) { return Error{std::string(cause)}; }

std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t comma = text.find(',');
        parts.emplace_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

/// The exclusive or of all characters.
unsigned checksum(std::string_view body) {
    unsigned sum = 0;
    for (const char c : body) sum ^= static_cast<unsigned char>(c);
    return sum;
}

/// The text before `*hh`, where the checksum is right.
Result<std::string_view> checkedBody(std::string_view text) {
    const std::size_t star = text.find('*');
    if (star == std::string_view::npos) return rejected(nmea_cause::no_checksum);
    const std::string_view digits = text.substr(star + 1);
    unsigned stated = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), stated, 16);
    if (digits.size() != 2 || read.ptr != digits.data() + 2) return rejected(nmea_cause::malformed);
    const std::string_view body = text.substr(0, star);
    if (checksum(body) != stated) return rejected(nmea_cause::bad_checksum);
    return body;
}

Result<Timestamp> tagTime(std::string_view digits) {
    std::int64_t count = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    // A sign would change the number of digits that tells the unit.
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || count < 0 || digits.front() == '-')
        return rejected(nmea_cause::bad_field);
    if (digits.size() == 13) return Timestamp(std::chrono::milliseconds(count));
    if (digits.size() == 10) return Timestamp(std::chrono::seconds(count));
    return rejected(nmea_cause::bad_field);
}

/// The time in the inside of a TAG block (without its backslashes), where it holds one.
Result<std::optional<Timestamp>> readTagBlock(std::string_view inside) {
    const auto body = checkedBody(inside);
    if (!body) return Error{body.error()};
    std::optional<Timestamp> time;
    for (const std::string& parameter : split(*body)) {
        if (!parameter.starts_with("c:")) continue;
        const auto read = tagTime(std::string_view(parameter).substr(2));
        if (!read) return Error{read.error()};
        time = *read;
    }
    return time;
}

/// Two letters of talker and three of sentence, but for a proprietary one, which begins with P and keeps its whole
/// address so that it is never taken for a standard one.
std::optional<std::string> sentenceId(std::string_view address) {
    const bool plain =
        std::ranges::all_of(address, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); });
    if (!plain || address.empty()) return std::nullopt;
    if (address.front() == 'P') return std::string(address);
    if (address.size() != 5) return std::nullopt;
    return std::string(address.substr(2));
}

}  // namespace

Result<NmeaSentence> parseNmeaLine(std::string_view line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == '\n' || line.back() == ' ')) line.remove_suffix(1);
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    if (!std::ranges::all_of(line, printable)) return rejected(nmea_cause::malformed);

    NmeaSentence sentence;
    if (line.starts_with('\\')) {
        const std::size_t end = line.find('\\', 1);
        if (end == std::string_view::npos) return rejected(nmea_cause::malformed);
        const auto time = readTagBlock(line.substr(1, end - 1));
        if (!time) return Error{time.error()};
        sentence.time = *time;
        line.remove_prefix(end + 1);
    }
    if (!line.starts_with('$') && !line.starts_with('!')) return rejected(nmea_cause::malformed);
    const auto body = checkedBody(line.substr(1));
    if (!body) return Error{body.error()};
    sentence.fields = split(*body);
    const auto id = sentenceId(sentence.fields.front());
    if (!id) return rejected(nmea_cause::malformed);
    sentence.id = *id;
    sentence.fields.erase(sentence.fields.begin());
    return sentence;
}

std::string nmeaSentence(std::string_view body) {
    constexpr char digits[] = "0123456789ABCDEF";
    const unsigned sum = checksum(body);
    std::string sentence = "$";
    sentence.append(body) += '*';
    sentence += digits[sum >> 4U & 15U];
    sentence += digits[sum & 15U];
    return sentence + "\r\n";
}

}  // namespace echotrail
