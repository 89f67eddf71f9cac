#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <google/protobuf/message_lite.h>
#include <google/protobuf/stubs/logging.h>

#include <cmath>
#include <limits>

namespace echotrail {
namespace {

/// How many bytes the character at `at` has; 0 where there is none. UTF-8, no more lenient than the messages' reader.
std::size_t characterAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(at);
    if (first < 0x80U) return 1;
    const std::size_t size = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(at + i) & 0xC0U) != 0x80U) return 0;
    const unsigned second = byte(at + 1);
    const bool too_long = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
    const bool beyond = (first == 0xEDU && second > 0x9FU) || (first == 0xF4U && second > 0x8FU);
    return too_long || beyond ? 0 : size;
}

}  // namespace

std::int64_t microsecondsOf(Timestamp time) { return time.time_since_epoch().count(); }

std::optional<Timestamp> timeFrom(std::int64_t us) {
    constexpr std::int64_t latest_us = 8'000'000'000'000'000;  // in the year 2223
    if (us < 0 || us > latest_us) return std::nullopt;
    return Timestamp(Microseconds(us));
}

std::int64_t optionalMicroseconds(const std::optional<Timestamp>& time) { return time ? microsecondsOf(*time) : 0; }

bool isSane(double value) { return std::isfinite(value) && std::abs(value) <= link_limits::farthest_m; }

std::string cleanText(std::string_view text, std::size_t longest) {
    std::string clean;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = characterAt(text, at);
        if (clean.size() + std::max<std::size_t>(size, 1) > longest) break;
        const auto first = static_cast<unsigned char>(text[at]);
        if (size == 0)
            clean += '?';
        else if (first < 0x20U || first == 0x7FU)
            clean += ' ';
        else
            clean += text.substr(at, size);
        at += std::max<std::size_t>(size, 1);
    }
    return clean;
}

bool parse(std::string_view text, google::protobuf::MessageLite& message) {
    // Whoever sends nonsense shall not write into our standard error with it.
    [[maybe_unused]] static google::protobuf::LogHandler* const before = google::protobuf::SetLogHandler(nullptr);
    return message.ParseFromArray(text.data(), static_cast<int>(text.size()));
}

void write(const NamedValue& value, wire::Parameter& out) {
    out.set_name(value.first);
    if (const bool* flag = std::get_if<bool>(&value.second)) out.set_flag(*flag);
    if (const int* whole = std::get_if<int>(&value.second)) out.set_whole(*whole);
    if (const double* real = std::get_if<double>(&value.second)) out.set_real(*real);
    if (const std::string* word = std::get_if<std::string>(&value.second)) out.set_word(*word);
}

std::optional<NamedValue> read(const wire::Parameter& in) {
    if (in.name().empty() || in.name().size() > link_limits::longest_word) return std::nullopt;
    NamedValue value{in.name(), false};
    switch (in.value_case()) {
        case wire::Parameter::kFlag:
            value.second = in.flag();
            return value;
        case wire::Parameter::kWhole:
            if (in.whole() < std::numeric_limits<int>::min() || in.whole() > std::numeric_limits<int>::max())
                return std::nullopt;
            value.second = static_cast<int>(in.whole());
            return value;
        case wire::Parameter::kReal:
            if (!std::isfinite(in.real())) return std::nullopt;
            value.second = in.real();
            return value;
        case wire::Parameter::kWord:
            if (in.word().size() > link_limits::longest_word) return std::nullopt;
            value.second = in.word();
            return value;
        case wire::Parameter::VALUE_NOT_SET:
            break;
    }
    return std::nullopt;
}

std::optional<std::vector<NamedValue>> read(const google::protobuf::RepeatedPtrField<wire::Parameter>& in) {
    if (static_cast<std::size_t>(in.size()) > link_limits::most_assignments) return std::nullopt;
    std::vector<NamedValue> values;
    for (const wire::Parameter& each : in) {
        auto value = read(each);
        if (!value) return std::nullopt;
        values.push_back(*std::move(value));
    }
    return values;
}

void write(const LinkParameters& parameters, wire::Parameters& out) {
    out.set_revision(parameters.revision);
    for (const NamedValue& value : parameters.values) write(value, *out.add_parameters());
}

std::optional<LinkParameters> read(const wire::Parameters& in) {
    auto values = read(in.parameters());
    if (!values) return std::nullopt;
    return LinkParameters{in.revision(), *std::move(values)};
}

void write(const LinkControl& control, wire::Control& out) {
    out.set_holder(control.holder);
    out.set_holder_name(control.holder_name);
    out.set_asking(control.asking);
    out.set_asking_name(control.asking_name);
}

LinkControl read(const wire::Control& in) {
    return {in.holder(), cleanText(in.holder_name(), link_limits::longest_name), in.asking(),
            cleanText(in.asking_name(), link_limits::longest_name)};
}

void write(const LinkLog& log, wire::Log& out) {
    out.set_time_us(microsecondsOf(log.time));
    out.set_weight(static_cast<wire::Log::Weight>(log.weight));
    out.set_text(log.text);
}

std::optional<LinkLog> read(const wire::Log& in) {
    const auto time = timeFrom(in.time_us());
    if (!time || !wire::Log::Weight_IsValid(in.weight())) return std::nullopt;
    return LinkLog{*time, static_cast<LinkLog::Weight>(in.weight()), cleanText(in.text(), link_limits::longest_text)};
}

}  // namespace echotrail
