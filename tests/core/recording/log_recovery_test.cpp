#include "core/recording/log_recovery.hpp"

#include "core/base/random.hpp"
#include "tests/core/recording/log_files.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace echotrail {
namespace {

class LogRecovery : public LogFolder {
protected:
    struct Outcome {
        RecoveryCounts counts;
        std::vector<Event> events;
    };
    Outcome recovered(const std::string& name) const {
        for (const char* left : {"out.echotrail", "out.echotrail-wal", "out.echotrail-shm"})
            std::filesystem::remove(pathOf(left));
        const auto before = content();
        const auto counts = recover(pathOf(name), pathOf("out.echotrail"));
        EXPECT_TRUE(counts) << counts.error();
        auto after = content();
        after.erase("out.echotrail");
        EXPECT_EQ(after, before) << "recovery touched what it read";
        return counts ? Outcome{*counts, eventsIn(pathOf("out.echotrail"))} : Outcome{};
    }
    /// A row lies whole in these bytes where its payload does, which ends it, and its beginning.
    static bool liesIn(const ByteVector& bytes, const Event& event) {
        return std::search(bytes.begin(), bytes.end(), event.payload.begin(), event.payload.end()) != bytes.end();
    }
    static ByteVector firstOf(const ByteVector& bytes, std::size_t count) {
        return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count)};
    }
};

TEST_F(LogRecovery, AWholeLogComesBackWhole) {
    auto writer = writerOf(pathOf("a.echotrail"), eventsOf(20));
    ASSERT_TRUE(writer->add(eventOf(20, 30'000)));
    ASSERT_TRUE(writer->addUpdate(UpdateKind::Track, log_start, "{}"));
    ASSERT_TRUE(writer->addUpdate(UpdateKind::Summary, log_start, R"({"pings":21})"));
    ASSERT_TRUE(writer->close());
    const auto [counts, events] = recovered("a.echotrail");
    EXPECT_TRUE(counts.whole());
    EXPECT_EQ(counts.results, 2u);
    auto reader = LogReader::open(pathOf("out.echotrail"));
    ASSERT_TRUE(reader);
    EXPECT_EQ((*reader)->header(), headerOfARun());
    EXPECT_EQ((*reader)->summary(), R"({"pings":21})");
    ASSERT_EQ(events.size(), 21u);
    EXPECT_EQ(events.back(), eventOf(20, 30'000));
}

TEST_F(LogRecovery, ALogCutAnywhereGivesEveryEventThatLiesWholeInTheRest) {
    const auto events = eventsOf(100);
    writeLog(pathOf("whole.echotrail"), events);
    const auto bytes = readBytes(pathOf("whole.echotrail"));
    std::filesystem::remove(pathOf("whole.echotrail"));
    ASSERT_GT(bytes.size(), 90u * 1024);
    for (std::size_t kept = 1024; kept < bytes.size(); kept += 1024) {
        SCOPED_TRACE(kept);
        const auto rest = firstOf(bytes, kept);
        put("cut.echotrail", rest);
        const auto outcome = recovered("cut.echotrail");
        std::vector<Event> expected;
        for (const Event& event : events)
            if (liesIn(rest, event)) expected.push_back(event);
        ASSERT_EQ(outcome.events, expected);
        EXPECT_FALSE(outcome.counts.whole());
    }
}

TEST_F(LogRecovery, AWriteAheadLogCutAnywhereGivesEveryEventThatLiesWholeInTheRest) {
    const auto events = eventsOf(60);
    const pid_t child = fork();
    if (child == 0) {
        const auto writer = writerOf(pathOf("a.echotrail"), events);
        raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(recovered("a.echotrail").counts.whole());
    const auto wal = readBytes(pathOf("a.echotrail-wal"));
    for (std::size_t kept = 1024; kept < wal.size(); kept += 4096) {
        SCOPED_TRACE(kept);
        const auto rest = firstOf(wal, kept);
        put("a.echotrail-wal", rest);
        const auto outcome = recovered("a.echotrail");
        EXPECT_FALSE(outcome.counts.whole());
        std::size_t expected = 0;
        for (const Event& event : events) expected += liesIn(rest, event) ? 1 : 0;
        EXPECT_EQ(outcome.events.size(), expected);
    }
}

TEST_F(LogRecovery, DamageAnywhereCostsOnlyTheRowsItHits) {
    const auto events = eventsOf(100);
    writeLog(pathOf("whole.echotrail"), events);
    const auto bytes = readBytes(pathOf("whole.echotrail"));
    std::filesystem::remove(pathOf("whole.echotrail"));
    RandomStream random(7, 1, 0);
    for (int round = 0; round < 40; ++round) {
        SCOPED_TRACE(round);
        auto damaged = bytes;
        const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size() - 512));
        for (std::size_t i = 0; i < 512; ++i) damaged[at + i] = static_cast<std::uint8_t>(random.uniform() * 256);
        put("damaged.echotrail", damaged);
        const auto outcome = recovered("damaged.echotrail");
        EXPECT_GE(outcome.events.size(), events.size() - 2);
        for (const Event& event : outcome.events) EXPECT_EQ(event, events[event.number]);
        for (const Event& event : events)
            if (!liesIn(damaged, event)) {
                EXPECT_EQ(std::count(outcome.events.begin(), outcome.events.end(), event), 0);
            }
    }
}

TEST_F(LogRecovery, PartsAreRecoveredTogetherAndAMissingOneIsCounted) {
    writeLog(pathOf("a.echotrail"), eventsOf(100), {.part_bytes = 20'000});
    const auto whole = recovered("a-0002.echotrail");
    EXPECT_TRUE(whole.counts.whole());
    EXPECT_EQ(whole.events, eventsOf(100));
    std::filesystem::remove(pathOf("a-0001.echotrail"));
    const auto outcome = recovered("a.echotrail");
    EXPECT_FALSE(outcome.counts.whole());
    EXPECT_EQ(outcome.counts.missing_events + outcome.events.size(), 100u);
    EXPECT_EQ(outcome.counts.parts + 1, whole.counts.parts);
}

TEST_F(LogRecovery, RefusesWhatIsNoLogAndAnExistingTarget) {
    put("text", ByteVector(5000, 'x'));
    EXPECT_FALSE(recover(pathOf("text"), pathOf("out.echotrail")));
    EXPECT_FALSE(recover(pathOf("none"), pathOf("out.echotrail")));
    writeLog(pathOf("a.echotrail"), eventsOf(3));
    const auto before = content();
    EXPECT_FALSE(recover(pathOf("a.echotrail"), pathOf("a.echotrail")));
    EXPECT_EQ(content(), before);
}

}  // namespace
}  // namespace echotrail
