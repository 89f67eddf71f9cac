#pragma once

#include "core/recording/log_reader.hpp"
#include "core/recording/log_writer.hpp"
#include "tests/core/seanet/test_bytes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace echotrail {

/// A folder of the test's own, gone when the test is over.
class LogFolder : public testing::Test {
protected:
    LogFolder()
        : folder_(testing::TempDir() + "echotrail-" + testing::UnitTest::GetInstance()->current_test_info()->name()) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~LogFolder() override { std::filesystem::remove_all(folder_); }

    std::string pathOf(const std::string& name) const { return folder_ + "/" + name; }
    std::map<std::string, ByteVector> content() const {
        std::map<std::string, ByteVector> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            files[entry.path().filename().string()] = readBytes(entry.path().string());
        return files;
    }
    void put(const std::string& name, const ByteVector& bytes) const {
        std::ofstream file(pathOf(name), std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }

    std::string folder_;
};

inline const Timestamp log_start{std::chrono::seconds(1'700'000'000)};

inline LogHeader headerOfARun() {
    return {"0.1.0", "SeaKing DFS, serial 123, node 2", "gain_db = 40.0\n", 18'000'000'000'000'000'000U, log_start};
}

/// One every 50 ms, its payload telling its number.
inline Event eventOf(std::uint64_t number, std::size_t bytes = 900) {
    Event event{number, EventKind::SonarBytes, {}, std::chrono::milliseconds(50 * number), ByteVector(bytes)};
    event.utc = log_start + event.monotonic;
    for (std::size_t i = 0; i < bytes; ++i)
        event.payload[i] = static_cast<std::uint8_t>(number * 31 + i * (number % 7 + 1));
    return event;
}

inline std::vector<Event> eventsOf(std::uint64_t count) {
    std::vector<Event> events;
    for (std::uint64_t number = 0; number < count; ++number) events.push_back(eventOf(number));
    return events;
}

/// Commits after every ten events; the caller closes it.
inline std::unique_ptr<LogWriter> writerOf(const std::string& path, const std::vector<Event>& events,
                                           LogOptions options = {}) {
    auto writer = LogWriter::create(path, headerOfARun(), options);
    EXPECT_TRUE(writer) << writer.error();
    for (const Event& event : events) {
        EXPECT_TRUE((*writer)->add(event));
        if (event.number % 10 != 9) continue;
        EXPECT_TRUE((*writer)->commit());
    }
    EXPECT_TRUE((*writer)->commit());
    return *std::move(writer);
}

inline void writeLog(const std::string& path, const std::vector<Event>& events, LogOptions options = {}) {
    EXPECT_TRUE(writerOf(path, events, options)->close());
}

inline std::vector<Event> allEvents(LogReader& reader) {
    std::vector<Event> events;
    while (auto event = reader.next()) events.push_back(std::move(*event));
    return events;
}

inline std::vector<Event> eventsIn(const std::string& path) {
    auto reader = LogReader::open(path);
    EXPECT_TRUE(reader) << reader.error();
    return reader ? allEvents(**reader) : std::vector<Event>{};
}

}  // namespace echotrail
