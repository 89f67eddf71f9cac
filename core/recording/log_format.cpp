#include "core/recording/log_format.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>

namespace echotrail::log_format {
namespace {

constexpr std::array<std::uint32_t, 256> makeTable() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) value = value & 1 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
        table[i] = value;
    }
    return table;
}
constexpr auto table = makeTable();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t crc) {
    crc = ~crc;
    for (const std::uint8_t byte : bytes) crc = table[(crc ^ byte) & 0xFF] ^ (crc >> 8);
    return ~crc;
}

std::uint32_t rowCrc(std::span<const std::int64_t> numbers, std::span<const std::uint8_t> payload) {
    std::uint32_t crc = 0;
    for (const std::int64_t number : numbers) {
        std::array<std::uint8_t, 8> bytes{};
        for (std::size_t i = 0; i < 8; ++i)
            bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * i));
        crc = crc32(bytes, crc);
    }
    return crc32(payload, crc);
}

std::uint32_t sessionCrc(std::string_view key, std::span<const std::uint8_t> value) {
    return crc32(value, crc32(bytesOf(key)));
}

std::string partPath(const std::string& first, int part) {
    if (part == 0) return first;
    char number[16];
    std::snprintf(number, sizeof number, "-%04d", part);
    const bool named = first.ends_with(suffix);
    const std::string stem = named ? first.substr(0, first.size() - suffix.size()) : first;
    return stem + number + (named ? std::string(suffix) : "");
}

std::string firstPartPath(const std::string& path, int part) {
    if (part == 0) return path;
    const bool named = path.ends_with(suffix);
    std::string stem = named ? path.substr(0, path.size() - suffix.size()) : path;
    const std::string ending = partPath("", part);
    if (stem.ends_with(ending)) stem.resize(stem.size() - ending.size());
    return stem + (named ? std::string(suffix) : "");
}

std::map<int, std::string> partsBeside(const std::string& first) {
    const std::string folder = first.substr(0, first.find_last_of('/') + 1);
    std::map<int, std::string> parts;
    std::error_code failure;
    for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, failure), end;
         !failure && entry != end; entry.increment(failure)) {
        const std::string path = folder + entry->path().filename().string();
        const std::string stem = path.substr(0, path.size() - (path.ends_with(suffix) ? suffix.size() : 0));
        int part = 0;
        const auto dash = stem.find_last_of('-');
        if (path != first && dash != std::string::npos)
            std::from_chars(stem.data() + dash + 1, stem.data() + stem.size(), part);
        if (part >= 0 && partPath(first, part) == path) parts[part] = path;
    }
    return parts;
}

}  // namespace echotrail::log_format
