#include "tests/core/recording/log_files.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace echotrail {
namespace {

/// What stands on the disk beside the rows: names, parts, the write-ahead log.
class LogFiles : public LogFolder {
protected:
    /// What a process leaves that is killed after its last commit.
    void leaveKilled(const std::string& path, const std::vector<Event>& events) const {
        const pid_t child = fork();
        if (child == 0) {
            const auto writer = writerOf(path, events);
            raise(SIGKILL);
        }
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status));
        ASSERT_TRUE(std::filesystem::exists(path + "-wal"));
    }
};

TEST_F(LogFiles, AHeaderOfAnyLengthIsKeptInEveryPart) {
    LogHeader header = headerOfARun();
    header.configuration = std::string(3 * log_format::chunk_bytes, 'x') + "the end";
    header.head.clear();
    auto writer = LogWriter::create(pathOf("a.echotrail"), header, {.part_bytes = 1'000});
    ASSERT_TRUE(writer) << writer.error();
    for (const Event& event : eventsOf(2)) {
        ASSERT_TRUE((*writer)->add(event));
        ASSERT_TRUE((*writer)->commit());
    }
    ASSERT_TRUE((*writer)->add(eventOf(2)));
    ASSERT_TRUE((*writer)->close());
    std::filesystem::remove(pathOf("a.echotrail"));
    auto reader = LogReader::open(pathOf("a-0001.echotrail"));
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ((*reader)->header(), header);
}

TEST_F(LogFiles, SkippedPingsAreFoundWithoutReadingTheRest) {
    auto events = eventsOf(30);
    for (const std::uint64_t number : {7u, 21u}) {
        const std::string sequence = std::to_string(number * 100);
        events[number].kind = EventKind::Skip;
        events[number].payload.assign(sequence.begin(), sequence.end());
    }
    writeLog(pathOf("a.echotrail"), events);
    auto reader = LogReader::open(pathOf("a.echotrail"));
    ASSERT_TRUE(reader);
    EXPECT_EQ((*reader)->skips().value(), (std::set<std::uint64_t>{700, 2100}));
}

TEST_F(LogFiles, ANeighbourWithTheNameOfAPartIsNotTakenForOne) {
    writeLog(pathOf("a-0001.echotrail"), eventsOf(5));
    const LogOptions one_part;
    EXPECT_FALSE(LogWriter::create(pathOf("a.echotrail"), headerOfARun(), one_part));
    std::filesystem::rename(pathOf("a-0001.echotrail"), pathOf("kept"));
    LogHeader other = headerOfARun();
    other.started += std::chrono::hours(1);
    auto writer = LogWriter::create(pathOf("a.echotrail"), other);
    ASSERT_TRUE(writer) << writer.error();
    ASSERT_TRUE((*writer)->add(eventOf(0)));
    ASSERT_TRUE((*writer)->close());
    std::filesystem::rename(pathOf("kept"), pathOf("a-0001.echotrail"));
    EXPECT_EQ(eventsIn(pathOf("a.echotrail")).size(), 1u);
    EXPECT_EQ(eventsIn(pathOf("a-0001.echotrail")).size(), 5u);
}

TEST_F(LogFiles, AFirstPartThatIsMissingIsCounted) {
    writeLog(pathOf("a.echotrail"), eventsOf(100), {.part_bytes = 20'000});
    std::filesystem::remove(pathOf("a.echotrail"));
    auto reader = LogReader::open(pathOf("a-0001.echotrail"));
    ASSERT_TRUE(reader) << reader.error();
    const auto found = allEvents(**reader);
    EXPECT_EQ((*reader)->counts().missing_parts, 1u);
    EXPECT_EQ((*reader)->counts().missing_events, 100 - found.size());
    EXPECT_EQ(found.back(), eventOf(99));
}

TEST_F(LogFiles, OpeningALogOfAKilledRunChangesNothing) {
    const auto events = eventsOf(40);
    leaveKilled(pathOf("a.echotrail"), events);
    for (const bool with_index : {true, false}) {
        SCOPED_TRACE(with_index);
        if (!with_index) std::filesystem::remove(pathOf("a.echotrail-shm"));
        const auto before = content();
        EXPECT_EQ(eventsIn(pathOf("a.echotrail")), events);
        EXPECT_EQ(content(), before);
    }
}

TEST_F(LogFiles, OpeningALogWithAnEmptyOrTornWriteAheadLogChangesNothing) {
    const auto events = eventsOf(40);
    leaveKilled(pathOf("a.echotrail"), events);
    const auto wal = readBytes(pathOf("a.echotrail-wal"));
    for (const std::size_t left : {std::size_t{0}, std::size_t{20}, std::size_t{32}, wal.size() / 2, wal.size() - 1}) {
        SCOPED_TRACE(left);
        put("a.echotrail-wal", ByteVector(wal.begin(), wal.begin() + static_cast<std::ptrdiff_t>(left)));
        const auto before = content();
        const auto found = eventsIn(pathOf("a.echotrail"));
        EXPECT_TRUE(std::equal(found.begin(), found.end(), events.begin()));
        EXPECT_EQ(content(), before);
    }
}

TEST_F(LogFiles, ALogIsReadWhileItIsWritten) {
    const auto events = eventsOf(60);
    const auto writer = writerOf(pathOf("a.echotrail"), {events.begin(), events.begin() + 30});
    {
        auto reader = LogReader::open(pathOf("a.echotrail"));
        ASSERT_TRUE(reader) << reader.error();
        EXPECT_FALSE((*reader)->closed());
        EXPECT_EQ(allEvents(**reader).size(), 30u);
        for (std::size_t i = 30; i < 60; ++i) ASSERT_TRUE(writer->add(events[i]));
        ASSERT_TRUE(writer->commit());
        (*reader)->rewind();
        EXPECT_EQ(allEvents(**reader), events);
        (*reader)->seek(events[50].utc);
        EXPECT_EQ((*reader)->next(), events[50]);
    }
    ASSERT_TRUE(writer->close());
    EXPECT_EQ(eventsIn(pathOf("a.echotrail")), events);
}

TEST_F(LogFiles, AHalfMadePartOfAKilledRunIsNoPartAndInNobodysWay) {
    writeLog(pathOf("a.echotrail"), eventsOf(5));
    put("a-0001.echotrail~", {1, 2, 3});
    EXPECT_EQ(eventsIn(pathOf("a.echotrail")), eventsOf(5));
    put("b.echotrail~", {1, 2, 3});
    writeLog(pathOf("b.echotrail"), eventsOf(5));
    EXPECT_EQ(eventsIn(pathOf("b.echotrail")), eventsOf(5));
    EXPECT_FALSE(std::filesystem::exists(pathOf("b.echotrail~")));
}

TEST_F(LogFiles, AWriteAheadLogLeftAloneIsNotTakenForThatOfANewLog) {
    leaveKilled(pathOf("a.echotrail"), eventsOf(40));
    std::filesystem::remove(pathOf("a.echotrail"));
    const auto before = content();
    const auto writer = LogWriter::create(pathOf("a.echotrail"), headerOfARun());
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().find("-wal exists"), std::string::npos) << writer.error();
    EXPECT_EQ(content(), before);
}

TEST_F(LogFiles, WhatIsNoLogIsRefusedInOneLine) {
    put("a.echotrail", ByteVector(40'000, 'x'));
    put("b.echotrail", {});
    for (const char* name : {"a.echotrail", "b.echotrail", "none.echotrail"}) {
        const auto reader = LogReader::open(pathOf(name));
        ASSERT_FALSE(reader);
        EXPECT_NE(reader.error().find("cannot open"), std::string::npos);
        EXPECT_EQ(reader.error().find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace echotrail
