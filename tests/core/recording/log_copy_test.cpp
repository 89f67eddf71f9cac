#include "core/recording/log_copy.hpp"

#include "core/recording/log_extract.hpp"
#include "core/recording/log_fetch.hpp"
#include "tests/core/recording/log_files.hpp"

namespace echotrail {
namespace {

/// A recording aboard that grows, and its copy elsewhere.
class LogCopies : public LogFolder {
protected:
    void begin(LogOptions options = {}) {
        auto made = LogWriter::create(aboard_, headerOfARun(), options);
        ASSERT_TRUE(made) << made.error();
        writer_ = *std::move(made);
    }
    void run(std::uint64_t events) {
        for (; events > 0; --events, ++number_) {
            ASSERT_TRUE(writer_->add(eventOf(number_, number_ % 5 == 0 ? 9'000 : 300)));
            if (number_ % 3 == 0) {
                const std::string text = "{\"n\":" + std::to_string(number_) + "}";
                ASSERT_TRUE(writer_->addUpdate(UpdateKind::Track, eventOf(number_, 0).utc, text));
            }
            if (number_ % 4 == 0) {
                ASSERT_TRUE(writer_->commit());
            }
        }
        ASSERT_TRUE(writer_->commit());
    }
    LogFetch fetch(bool newest_first) {
        auto copy = LogCopy::open(copy_, headerOfARun());
        EXPECT_TRUE(copy) << copy.error();
        return {*std::move(copy), describeLog(aboard_, LogUse::Written).value(), newest_first};
    }
    LogRows ask(LogFetch& fetch, const LogRowsWanted& wanted) {
        LogRows rows = readLogRows(aboard_, LogUse::Written, wanted).value();
        const auto taken = fetch.take(wanted, rows);
        EXPECT_TRUE(taken) << taken.error();
        return rows;
    }
    int askForAll(LogFetch& fetch) {
        int asked = 0;
        for (; asked < 10'000; ++asked) {
            const auto wanted = fetch.next(4'000);
            if (!wanted) break;
            ask(fetch, *wanted);
        }
        EXPECT_TRUE(fetch.copy().commit());
        return asked;
    }
    void lookForMore(LogFetch& fetch) {
        for (int i = 0; i < 4; ++i) {
            ask(fetch, fetch.lookForMore(4'000));
            askForAll(fetch);
        }
    }
    static std::vector<LogRow> allRows(const std::string& path, LogUse use) {
        std::vector<LogRow> all;
        const auto log = describeLog(path, use);
        EXPECT_TRUE(log) << log.error();
        for (std::size_t part = 0; log && part < log->parts.size(); ++part)
            for (const LogTable table : log_tables) {
                const auto rows = readLogRows(
                    path, use, {static_cast<int>(part), table, 1, log->parts[part].of(table), std::size_t{1} << 30});
                EXPECT_TRUE(rows) << rows.error();
                if (rows) all.insert(all.end(), rows->rows.begin(), rows->rows.end());
            }
        return all;
    }
    bool isWhole() const { return allRows(copy_, LogUse::Resting) == allRows(aboard_, LogUse::Written); }

    std::string aboard_ = pathOf("aboard.echotrail"), copy_ = pathOf("copy.echotrail");
    std::unique_ptr<LogWriter> writer_;
    std::uint64_t number_ = 0;
};

TEST_F(LogCopies, ACopyOfAWholeLogIsThatLog) {
    begin();
    run(60);
    LogFetch fetched = fetch(false);
    EXPECT_GT(askForAll(fetched), 20) << "in pieces";
    ASSERT_TRUE(fetched.copy().close());
    EXPECT_TRUE(isWhole());
    ASSERT_TRUE(writer_->close());
    EXPECT_EQ(eventsIn(copy_), eventsIn(aboard_));
    auto reader = LogReader::open(copy_);
    ASSERT_TRUE(reader) << reader.error();
    EXPECT_EQ((*reader)->header(), headerOfARun());
    EXPECT_TRUE((*reader)->closed());
}

TEST_F(LogCopies, OfARunThatGoesOnWhatIsNewComesFirstAndTheRestAfterIt) {
    begin();
    run(40);
    LogFetch fetched = fetch(true);
    EXPECT_EQ(fetched.progress().missed, 0) << "nothing since it was begun";
    run(8);
    ask(fetched, fetched.lookForMore(100'000));  // only how far the results are
    const LogRowsWanted more = fetched.lookForMore(100'000);
    EXPECT_EQ(ask(fetched, more).rows.size(), 8U + 2U * 2U) << "an event of 9000 bytes has three rows";
    EXPECT_GT(more.first, 40);
    const LogRowsWanted results = fetched.next(4'000).value();
    EXPECT_EQ(results.table, LogTable::Results);
    EXPECT_EQ(ask(fetched, results).rows.size(), 2U) << "those after the events they came from";
    EXPECT_EQ(fetched.next(4'000).value().first, 1) << "then the beginning";
    askForAll(fetched);
    lookForMore(fetched);
    EXPECT_TRUE(isWhole());
}

TEST_F(LogCopies, WhatWasMissedIsKnownAndFilledInItsPlace) {
    begin();
    run(20);
    LogFetch fetched = fetch(true);
    askForAll(fetched);
    ASSERT_TRUE(isWhole());
    run(50);  // nobody listens
    ask(fetched, fetched.lookForMore(100));
    ask(fetched, fetched.lookForMore(100));
    const auto before = fetched.progress();
    EXPECT_GT(before.missed, 50);
    EXPECT_EQ(before.there - before.rows, before.missed);
    EXPECT_FALSE(isWhole());
    askForAll(fetched);
    EXPECT_EQ(fetched.progress().missed, 0);
    EXPECT_TRUE(isWhole());
}

TEST_F(LogCopies, ACopyThatWasCutOffGoesOnWhereItWas) {
    begin();
    run(40);
    for (int round = 0; round < 6; ++round) {
        LogFetch fetched = fetch(true);
        run(7);
        ask(fetched, fetched.lookForMore(2'000));
        ask(fetched, fetched.lookForMore(2'000));
        ask(fetched, fetched.next(2'000).value());
        ask(fetched, fetched.next(2'000).value());
        ASSERT_TRUE(fetched.copy().commit());
        run(7);
    }
    auto reader = LogReader::open(copy_);
    ASSERT_TRUE(reader) << reader.error();
    allEvents(**reader);
    EXPECT_GT((*reader)->counts().missing_events, 0U) << "a log with gaps says so";
    EXPECT_EQ((*reader)->counts().damaged_rows, 0U);
    LogFetch fetched = fetch(true);
    EXPECT_GT(fetched.progress().missed, 0);
    EXPECT_LT(fetched.progress().missed, fetched.progress().there - fetched.progress().rows)
        << "the beginning was never here";
    askForAll(fetched);
    EXPECT_TRUE(isWhole());
}

TEST_F(LogCopies, ACopyHoldsNoResultWhoseEventsItDoesNotHave) {
    begin();
    run(5);
    LogFetch fetched = fetch(true);
    for (int round = 0; round < 200; ++round) {
        if (round % 3 == 0) run(2);
        const auto next = fetched.next(1'500);
        ask(fetched, next ? *next : fetched.lookForMore(1'500));
        ASSERT_TRUE(fetched.copy().commit());
        // From the first look on nothing is missing before the last row, so that the last ones tell.
        const std::int64_t results = fetched.copy().held(0, LogTable::Results).last();
        if (results == 0) continue;
        const auto row = readLogRows(copy_, LogUse::Written, {0, LogTable::Results, results, results, 100}).value();
        const auto events = fetched.copy().held(0, LogTable::Events).last();
        const auto event = readLogRows(copy_, LogUse::Written, {0, LogTable::Events, events, events, 100}).value();
        EXPECT_LE(row.rows.at(0).numbers[1], event.rows.at(0).numbers[2]) << "round " << round;
    }
}

TEST_F(LogCopies, PartsComeOverAsParts) {
    begin({.part_bytes = 20'000});
    run(30);
    LogFetch fetched = fetch(true);
    run(40);
    lookForMore(fetched);
    for (int i = 0; i < 10; ++i) lookForMore(fetched);
    ASSERT_TRUE(fetched.copy().close());
    EXPECT_TRUE(std::filesystem::exists(pathOf("copy-0002.echotrail")));
    EXPECT_TRUE(isWhole());
    ASSERT_TRUE(writer_->close());
    EXPECT_EQ(eventsIn(copy_), eventsIn(aboard_));
}

TEST_F(LogCopies, WhatWasNotAskedForIsRefusedAndAnotherRunsCopyStays) {
    begin();
    run(10);
    LogFetch fetched = fetch(false);
    const LogRowsWanted wanted = fetched.next(4'000).value();
    LogRows rows = readLogRows(aboard_, LogUse::Written, wanted).value();
    rows.rows.front().row = 0;
    EXPECT_FALSE(fetched.take(wanted, rows));
    rows.rows.front().row = 1'000'000;
    EXPECT_FALSE(fetched.take(wanted, rows));
    ASSERT_TRUE(fetched.copy().close());
    LogHeader other = headerOfARun();
    other.seed = 5;
    EXPECT_FALSE(LogCopy::open(copy_, other));
}

TEST_F(LogCopies, RowsThatAreSaidToBeThereAndAreNotAreNotAskedForWithoutEnd) {
    begin();
    run(10);
    LogFetch fetched = fetch(false);
    int asked = 0;
    while (const auto wanted = fetched.next(4'000)) {
        ASSERT_LT(++asked, 100);
        ASSERT_TRUE(fetched.take(*wanted, {wanted->table, {}, asked % 2 ? wanted->last : 0, 1}));
    }
    ASSERT_TRUE(fetched.copy().close());
}

}  // namespace
}  // namespace echotrail
