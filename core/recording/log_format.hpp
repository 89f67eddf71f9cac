#pragma once

#include "core/base/time.hpp"
#include "core/data/event.hpp"
#include "core/data/log_rows.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

/// The layout of an .echotrail log: an SQLite 3 database in parts NAME.echotrail, NAME-0001.echotrail, …, each whole in
/// itself. Table `session` (row, key, crc, value): what stands above the run, in every part; a value of more than
/// `chunk_bytes` lies in several rows of its key. Table `events` (row, number, kind, utc_us,
/// monotonic_us, chunk, chunks, crc, payload): an event of more than `chunk_bytes` lies in several rows. Table
/// `results` (row, kind, utc_us, crc, payload): what the tracker found, JSON. The crc is the CRC-32 of IEEE 802.3 over
/// the row's other numbers as little-endian 64-bit integers, or its key, and its payload. No row is as long as a page,
/// so that each lies whole in one and can be found without trusting anything around it (log_recovery.hpp). A copy that
/// is not whole yet has a third table (log_copy.hpp).
namespace echotrail {

/// The numbers are stored: they never change their meaning.
enum class UpdateKind : std::uint8_t { Track = 1, Region = 2, Summary = 3 };

namespace log_format {

inline constexpr int version = 1;
inline constexpr std::int32_t application_id = 0x45544C31;  // "ETL1", in the file's header
inline constexpr int page_bytes = 16'384;
inline constexpr std::size_t chunk_bytes = 4'096;  // several rows to a page, and none that overflows it
inline constexpr std::string_view suffix = ".echotrail";

/// CRC-32 (IEEE 802.3, reflected), carried on from `crc`.
std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t crc = 0);

/// Of an event's or a result's row.
std::uint32_t rowCrc(std::span<const std::int64_t> numbers, std::span<const std::uint8_t> payload);

/// Of a session's row.
std::uint32_t sessionCrc(std::string_view key, std::span<const std::uint8_t> value);

inline std::span<const std::uint8_t> bytesOf(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Part 0 is NAME.echotrail itself, part 1 NAME-0001.echotrail, …
std::string partPath(const std::string& first, int part);
/// Back from the path of a part to that of part 0.
std::string firstPartPath(const std::string& path, int part);
/// The files there are whose names are those of part 0 and of the parts after it, by their numbers.
std::map<int, std::string> partsBeside(const std::string& first);

}  // namespace log_format
}  // namespace echotrail
