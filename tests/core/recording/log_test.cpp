#include "core/recording/log_reader.hpp"
#include "core/recording/log_writer.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace echotrail {
namespace {

constexpr Timestamp start{Microseconds(1'700'000'000'000'000)};

class Log : public testing::Test {
protected:
    void SetUp() override {
        folder_ = testing::TempDir() + "log_" + testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        path_ = folder_ + "/a run #1?.echotrail";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    static LogHeader header() { return {"1.2.3", "SeaKing", "range_m = 50.0\n", 7, start}; }
    static Event event(std::uint64_t number, std::size_t bytes) {
        Event event{
            number, EventKind::SonarBytes, start + Microseconds(number * 50'000), Microseconds(number * 50'000), {}};
        for (std::size_t i = 0; i < bytes; ++i) event.payload.push_back(static_cast<std::uint8_t>(i * 7 + number));
        return event;
    }
    std::unique_ptr<LogWriter> create(LogOptions options = {}) {
        auto writer = LogWriter::create(path_, header(), options);
        EXPECT_TRUE(writer) << writer.error();
        return *std::move(writer);
    }
    static std::unique_ptr<LogReader> open(const std::string& path) {
        auto reader = LogReader::open(path);
        EXPECT_TRUE(reader) << reader.error();
        return reader ? *std::move(reader) : nullptr;
    }
    static std::vector<Event> allOf(LogReader& reader) {
        std::vector<Event> events;
        while (auto event = reader.next()) events.push_back(std::move(*event));
        return events;
    }
    std::string folder_, path_;
};

TEST_F(Log, GivesBackWhatWasWritten) {
    std::vector<Event> events;
    {
        const auto writer = create();
        for (const std::size_t bytes : {0U, 1U, 4095U, 4096U, 4097U, 70'000U}) {
            events.push_back(event(events.size(), bytes));
            ASSERT_TRUE(writer->add(events.back()));
        }
        ASSERT_TRUE(writer->addUpdate(UpdateKind::Track, start, "{\"track\":1}"));
        ASSERT_TRUE(writer->addUpdate(UpdateKind::Summary, start, "{\"pings\":6}"));
        ASSERT_TRUE(writer->close());
    }
    EXPECT_FALSE(std::filesystem::exists(path_ + "-wal"));
    const auto reader = open(path_);
    EXPECT_EQ(reader->header(), header());
    EXPECT_EQ(allOf(*reader), events);
    EXPECT_EQ(reader->events(), events.size());
    EXPECT_TRUE(reader->closed());
    EXPECT_FALSE(reader->counts().any());
    EXPECT_EQ(reader->nextResult()->text, "{\"track\":1}");
    EXPECT_EQ(reader->summary(), "{\"pings\":6}");
}

TEST_F(Log, PartsOpenAsOneWhicheverIsNamed) {
    {
        const auto writer = create({.part_bytes = 10'000});
        for (std::uint64_t i = 0; i < 50; ++i) {
            ASSERT_TRUE(writer->add(event(i, 900)));
            ASSERT_TRUE(writer->commit());
        }
        ASSERT_TRUE(writer->close());
    }
    for (const int part : {0, 2}) {
        const auto reader = open(log_format::partPath(path_, part));
        EXPECT_GE(reader->parts(), 4);
        EXPECT_EQ(allOf(*reader).size(), 50u);
        EXPECT_FALSE(reader->counts().any());
    }
    std::filesystem::remove(log_format::partPath(path_, 1));
    const auto reader = open(log_format::partPath(path_, 2));
    EXPECT_LT(allOf(*reader).size(), 50u);
    EXPECT_EQ(reader->counts().missing_parts, 1u);
    EXPECT_GT(reader->counts().missing_events, 0u);
}

TEST_F(Log, SeekGivesTheFirstEventAtOrAfterATime) {
    {
        const auto writer = create({.part_bytes = 20'000});
        for (std::uint64_t i = 0; i < 100; ++i) {
            ASSERT_TRUE(writer->add(event(i, i % 10 == 0 ? 9000 : 100)));
            ASSERT_TRUE(writer->commit());
        }
        ASSERT_TRUE(writer->close());
    }
    const auto reader = open(path_);
    for (const std::uint64_t number : {0U, 1U, 10U, 11U, 57U, 99U}) {
        reader->seek(start + Microseconds(number * 50'000));
        EXPECT_EQ(reader->next(), event(number, number % 10 == 0 ? 9000 : 100));
        if (number == 0) continue;
        reader->seek(start + Microseconds(number * 50'000 - 1));
        EXPECT_EQ(reader->next()->number, number);
    }
    reader->seek(start + Microseconds(100 * 50'000));
    EXPECT_FALSE(reader->next());
}

TEST_F(Log, ReadingChangesNothing) {
    {
        const auto writer = create();
        ASSERT_TRUE(writer->add(event(0, 5000)));
        ASSERT_TRUE(writer->close());
    }
    const auto bytes = [&] {
        std::ifstream file(path_, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string before = bytes();
    allOf(*open(path_));
    EXPECT_EQ(bytes(), before);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(Log, ADamagedRowCostsItsEventAndIsCounted) {
    {
        const auto writer = create();
        for (std::uint64_t i = 0; i < 5; ++i) ASSERT_TRUE(writer->add(event(i, 300)));
        ASSERT_TRUE(writer->close());
    }
    std::string bytes;
    {
        std::ifstream file(path_, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    const Event third = event(2, 300);
    const auto at = bytes.find(std::string(third.payload.begin(), third.payload.end()));
    ASSERT_NE(at, std::string::npos);
    bytes[at + 100] = static_cast<char>(bytes[at + 100] ^ 0x10);
    std::ofstream(path_, std::ios::binary) << bytes;
    const auto reader = open(path_);
    EXPECT_EQ(allOf(*reader).size(), 4u);
    EXPECT_EQ(reader->counts().damaged_rows, 1u);
    EXPECT_EQ(reader->counts().missing_events, 1u);
}

TEST_F(Log, AnExistingFileIsNotWrittenOver) {
    std::ofstream(path_) << "precious";
    const auto writer = LogWriter::create(path_, header());
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().find("exists"), std::string::npos);
}

TEST_F(Log, AKilledWriterLosesNothingThatWasCommitted) {
    for (int round = 0; round < 5; ++round) {
        path_ = folder_ + "/killed" + std::to_string(round) + ".echotrail";
        int tell[2];
        ASSERT_EQ(pipe(tell), 0);
        const pid_t child = fork();
        if (child == 0) {
            auto writer = LogWriter::create(path_, header());
            for (std::uint64_t i = 0; writer; ++i) {
                if (!(*writer)->add(event(i, 900))) _exit(1);
                if (i % 3 != 2) continue;
                if (!(*writer)->commit()) _exit(1);
                if (write(tell[1], &i, sizeof i) != sizeof i) _exit(1);
            }
            _exit(1);
        }
        close(tell[1]);
        std::uint64_t committed = 0, told = 0;
        for (int i = 0; i < 20 + 7 * round; ++i) ASSERT_EQ(read(tell[0], &committed, sizeof committed), 8);
        kill(child, SIGKILL);
        while (read(tell[0], &told, sizeof told) == 8) committed = told;
        close(tell[0]);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
        const auto reader = open(path_);
        EXPECT_FALSE(reader->closed());
        const auto events = allOf(*reader);
        EXPECT_GT(events.size(), committed);
        for (std::size_t i = 0; i < events.size(); ++i) ASSERT_EQ(events[i], event(i, 900));
        EXPECT_FALSE(reader->counts().any());
    }
}

}  // namespace
}  // namespace echotrail
