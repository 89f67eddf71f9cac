#pragma once

#include "core/recording/recording.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace echotrail {

/// A file of the test's own, gone when the test is over.
class TemporaryFile {
public:
    explicit TemporaryFile(const ByteVector& bytes)
        : path_(testing::TempDir() + "echotrail-" + testing::UnitTest::GetInstance()->current_test_info()->name() +
                "-" + std::to_string(++number_)) {
        std::ofstream file(path_, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    ~TemporaryFile() { std::filesystem::remove(path_); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

private:
    static inline int number_ = 0;
    std::string path_;
};

inline std::vector<Ping> allPings(PingSource& source) {
    std::vector<Ping> pings;
    while (auto ping = source.next()) pings.push_back(std::move(*ping));
    return pings;
}

struct Played {
    std::vector<Ping> pings;
    SourceCounts counts;
};

/// What a file of these bytes gives; nothing where it does not open.
inline Played play(const ByteVector& bytes) {
    const TemporaryFile file(bytes);
    auto source = openRecording(file.path());
    if (!source) return {};
    Played played;
    played.pings = allPings(**source);
    played.counts = (*source)->counts();
    return played;
}

/// A table whose first line names its columns; every row from name to text.
inline std::vector<std::map<std::string, std::string>> readTable(const std::string& path) {
    const auto cellsOf = [](const std::string& line) {
        std::vector<std::string> cells;
        std::istringstream rest(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
        for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
        return cells;
    };
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const auto names = cellsOf(line);
    std::vector<std::map<std::string, std::string>> rows;
    while (std::getline(file, line)) {
        const auto cells = cellsOf(line);
        for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i) {
            if (i == 0) rows.emplace_back();
            rows.back()[names[i]] = cells[i];
        }
    }
    return rows;
}

/// The usual CRC-32 (IEEE 802.3), bit by bit, in eight hex digits.
inline std::string crc32(const ByteVector& bytes) {
    std::uint32_t crc = ~0u;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0u);
    }
    char text[9];
    std::snprintf(text, sizeof text, "%08x", static_cast<unsigned>(~crc));
    return text;
}

}  // namespace echotrail
