#include "app/io/recording_path.hpp"
#include "app/io/tracker_link.hpp"
#include "app/io/tracker_service.hpp"
#include "core/recording/log_reader.hpp"
#include "tests/app/io/event_loop.hpp"
#include "tests/app/io/slow_way.hpp"

#include <gtest/gtest.h>

#include <QCryptographicHash>
#include <QDir>
#include <QTemporaryDir>
#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

namespace echotrail {
namespace {

LogHeader headerOf(std::int64_t run) {
    return {"test", "no head", "", 7, Timestamp(std::chrono::seconds(1'700'000'000 + run))};
}

/// A tracker at work whose head says nothing in particular: every 10 ms bytes come, and now and then it finds
/// something.
struct Vehicle {
    Vehicle(const std::string& folder, const std::string& path, std::int64_t run, std::uint16_t port = 0)
        : runner({}, 7, LogWriter::create(path, headerOf(run)).value()),
          head(parseLiveAddresses("simulation://demo", "").value(), {}, runner),
          service({}, runner, head, "test", RecordingShelf(folder, path)) {
        LinkAddress address = parseLinkAddress("tcp://127.0.0.1:0").value();
        address.port = port;
        own_port = service.start(address).value().port;
        QObject::connect(&work, &QTimer::timeout, &work, [this] { live(); });
        work.start(10);
    }
    ~Vehicle() { end(); }
    void live() {
        runner.post(EventKind::SonarBytes,
                    std::vector<std::uint8_t>(lived % 40 ? 400 : 9'000, static_cast<std::uint8_t>(lived * 7)));
        if (lived % 3 == 0)
            runner.record({UpdateKind::Track, runner.now(), "{\"look\":" + std::to_string(lived) + "}"});
        ++lived;
    }
    /// As when it is switched off: the log gets its last rows when nobody is connected any more.
    void end() {
        work.stop();
        service.stop();
        runner.finish();
        runner.closeLog();
    }
    LiveRunner runner;
    HeadLink head;
    TrackerService service;
    QTimer work;
    int lived = 0;
    std::uint16_t own_port = 0;
};

LinkAddress at(std::uint16_t port) {
    LinkAddress address = parseLinkAddress("tcp://127.0.0.1:0").value();
    address.port = port;
    return address;
}

using RowHashes = std::map<std::tuple<int, LogTable, std::int64_t>, QByteArray>;

/// Of every row of a log, over its numbers and its payload.
RowHashes hashesOf(const std::string& path, LogUse use) {
    RowHashes hashes;
    const auto log = describeLog(path, use);
    EXPECT_TRUE(log) << log.error();
    for (int part = 0; log && part < static_cast<int>(log->parts.size()); ++part)
        for (const LogTable table : log_tables) {
            const auto read = readLogRows(path, use, {part, table, 1, 1 << 30, std::size_t{1} << 30});
            EXPECT_TRUE(read) << read.error();
            for (const LogRow& row : read->rows) {
                QCryptographicHash hash(QCryptographicHash::Sha256);
                hash.addData(QByteArray(reinterpret_cast<const char*>(row.numbers.data()), sizeof row.numbers));
                hash.addData(QByteArray(reinterpret_cast<const char*>(row.payload.data()),
                                        static_cast<qsizetype>(row.payload.size())));
                hashes[{part, table, row.row}] = hash.result();
            }
        }
    return hashes;
}

class KeptRecordings : public testing::Test {
protected:
    std::string aboard(const std::string& name) const { return folder_.path().toStdString() + "/aboard/" + name; }
    std::string ashore() const { return folder_.path().toStdString() + "/ashore"; }
    std::unique_ptr<Vehicle> begin(std::int64_t run, std::uint16_t port = 0) {
        QDir().mkpath(QString::fromStdString(aboard("")));
        return std::make_unique<Vehicle>(aboard(""), aboard("run" + std::to_string(run) + ".echotrail"), run, port);
    }
    std::unique_ptr<TrackerLink> console(std::uint16_t port) {
        auto link = std::make_unique<TrackerLink>(at(port), LinkIdentity{"shore", "test"}, ashore());
        link->open();
        return link;
    }
    static KeptRecording record(const TrackerLink& link) { return link.state().record.value_or(KeptRecording{}); }
    static bool keepsAll(const TrackerLink& link, std::int64_t rows) {
        return becomes([&] {
            const KeptRecording kept = record(link);
            return kept.asking && kept.rows.rows >= rows && kept.rows.missed == 0 && kept.whole;
        });
    }
    QTemporaryDir folder_;
};

TEST_F(KeptRecordings, WhatWasMissedWhileTheCableWasOutIsThereAgainRowByRow) {
    auto vehicle = begin(1);
    SlowWay cable(vehicle->own_port, {.delay_ms = 50});
    auto link = console(cable.port());
    ASSERT_TRUE(keepsAll(*link, 50)) << record(*link).error;
    for (int round = 0; round < 2; ++round) {
        cable.unplug();
        ASSERT_TRUE(becomes([&] { return !link->state().up; }));
        const auto before = record(*link).rows.rows;
        const int lived = vehicle->lived;
        ASSERT_TRUE(becomes([&] { return vehicle->lived > lived + 150; })) << "it works on, as if nobody were there";
        EXPECT_EQ(record(*link).rows.rows, before);
        cable.plug();
        ASSERT_TRUE(becomes([&] { return record(*link).rows.rows > before + 180; }));
        ASSERT_TRUE(keepsAll(*link, 0)) << record(*link).error;
    }
    const std::string copy = record(*link).path;
    link.reset();
    const RowHashes here = hashesOf(copy, LogUse::Resting);
    const RowHashes there = hashesOf(aboard("run1.echotrail"), LogUse::Written);
    std::map<LogTable, std::int64_t> last;
    for (const auto& [place, hash] : here) last[std::get<1>(place)] = std::get<2>(place);
    EXPECT_GT(last[LogTable::Events], 300);
    EXPECT_GT(last[LogTable::Results], 100);
    for (const auto& [place, hash] : there) {
        if (std::get<2>(place) > last[std::get<1>(place)]) continue;  // not committed aboard when the console went
        const auto found = here.find(place);
        ASSERT_NE(found, here.end()) << "row " << std::get<2>(place);
        EXPECT_EQ(found->second, hash) << "row " << std::get<2>(place);
    }
    auto reader = LogReader::open(copy);
    ASSERT_TRUE(reader) << reader.error();
    std::uint64_t events = 0;
    while ((*reader)->next()) ++events;
    EXPECT_GT(events, 300U);
    EXPECT_FALSE((*reader)->counts().any());
    EXPECT_NE(QString::fromStdString(copy).indexOf("/ashore/" + QSysInfo::machineHostName().left(1)), -1) << copy;
    EXPECT_TRUE(copy.ends_with("-20231114-221321.echotrail")) << "named by tracker and time: " << copy;
}

TEST_F(KeptRecordings, AConsoleThatIsStartedAgainGoesOnWithItsCopy) {
    auto vehicle = begin(1);
    auto link = console(vehicle->own_port);
    ASSERT_TRUE(keepsAll(*link, 50)) << record(*link).error;
    const std::string copy = record(*link).path;
    link.reset();
    const int lived = vehicle->lived;
    ASSERT_TRUE(becomes([&] { return vehicle->lived > lived + 100; }));
    link = console(vehicle->own_port);
    ASSERT_TRUE(keepsAll(*link, 180)) << record(*link).error;
    EXPECT_EQ(record(*link).path, copy);
}

TEST_F(KeptRecordings, TheCopyOfARunThatHasEndedIsMadeWholeWhenTheTrackerIsBack) {
    auto vehicle = begin(1);
    auto link = console(vehicle->own_port);
    const std::uint16_t port = vehicle->own_port;
    ASSERT_TRUE(keepsAll(*link, 50)) << record(*link).error;
    const std::string first = record(*link).path;
    vehicle.reset();
    vehicle = begin(2, port);
    ASSERT_TRUE(becomes([&] { return record(*link).path != first && record(*link).rows.rows > 50; }));
    ASSERT_TRUE(becomes([&] {
        const auto fetched = link->state().fetched;
        return fetched && fetched->whole && fetched->path == first;
    }));
    link.reset();
    EXPECT_EQ(hashesOf(first, LogUse::Resting), hashesOf(aboard("run1.echotrail"), LogUse::Resting));
    EXPECT_FALSE(LogReader::open(first).value()->summary().empty()) << "its last word";
}

TEST_F(KeptRecordings, WhatLiesBesideTheRunThatIsWrittenIsOnTheShelfToo) {
    QTemporaryDir usual, chosen;
    const auto in = [](const QTemporaryDir& folder, const char* name) { return folder.filePath(name).toStdString(); };
    for (const std::string& path : {in(usual, "before.echotrail"), in(chosen, "run1.echotrail"),
                                    in(chosen, "run2.echotrail"), in(usual, "run1.echotrail")})
        ASSERT_TRUE(LogWriter::create(path, headerOf(1)).value()->close());
    RecordingShelf shelf(usual.path().toStdString(), in(chosen, "run2.echotrail"));
    std::vector<std::string> names;
    for (const auto& entry : shelf.list()) names.push_back(entry.name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"before.echotrail", "run1.echotrail", "run2.echotrail"}));
}

TEST_F(KeptRecordings, ARecordingIsFetchedByItsNameInTheListAndByNothingElse) {
    begin(1)->end();
    auto vehicle = begin(2);
    TrackerLink link(at(vehicle->own_port), {"shore", "test"});
    link.open();
    ASSERT_TRUE(becomes([&] { return link.state().up; }));
    link.listRecordings();
    ASSERT_TRUE(becomes([&] { return link.state().recordings.size() == 2; }));
    const auto entries = link.state().recordings;
    EXPECT_EQ(entries[0].name, "run2.echotrail");
    EXPECT_TRUE(entries[0].written);
    EXPECT_EQ(entries[1].name, "run1.echotrail");
    EXPECT_GT(entries[1].bytes, 0U);
    for (const std::string name : {"../aboard/run1.echotrail", "/etc/passwd", "run1", "run1.echotrail/", ".", "*"}) {
        link.fetch(name, ashore());
        ASSERT_TRUE(becomes([&] {
            const auto fetched = link.state().fetched;
            return fetched && fetched->error.find("no recording of that name") != std::string::npos;
        })) << name;
        link.cancelFetch();
    }
    EXPECT_FALSE(QDir(QString::fromStdString(ashore())).exists()) << "nothing was made";
    link.fetch("run1.echotrail", ashore());
    ASSERT_TRUE(becomes([&] { return link.state().fetched && link.state().fetched->whole; }))
        << link.state().fetched->error;
    EXPECT_EQ(hashesOf(link.state().fetched->path, LogUse::Resting),
              hashesOf(aboard("run1.echotrail"), LogUse::Resting));
}

TEST_F(KeptRecordings, AFetchThatIsCancelledIsTakenUpAgain) {
    auto vehicle = begin(1);
    ASSERT_TRUE(becomes([&] { return vehicle->lived > 200; }));
    vehicle->end();
    vehicle = begin(2);
    SlowWay radio(vehicle->own_port, {.bytes_per_second = 60'000});
    TrackerLink link(at(radio.port()), {"shore", "test"});
    link.open();
    link.fetch("run1.echotrail", ashore());
    const auto rows = [&] { return link.state().fetched.value_or(KeptRecording{}).rows; };
    ASSERT_TRUE(becomes([&] { return rows().rows > 20; }));
    link.cancelFetch();
    const auto before = rows();
    const std::uint64_t bytes = link.state().fetched->bytes;
    EXPECT_LT(before.rows, before.there);
    EXPECT_FALSE(link.state().fetched->whole);
    link.fetch("run1.echotrail", ashore());
    ASSERT_TRUE(becomes([&] { return link.state().fetched->whole; })) << link.state().fetched->error;
    std::uint64_t all = 0;
    for (const LogTable table : log_tables)
        for (const LogRow& row :
             readLogRows(aboard("run1.echotrail"), LogUse::Resting, {0, table, 1, 1 << 30, std::size_t{1} << 30})
                 .value()
                 .rows)
            all += row.payload.size();
    EXPECT_EQ(bytes + link.state().fetched->bytes, all) << "what was here has not come again";
    EXPECT_EQ(hashesOf(link.state().fetched->path, LogUse::Resting),
              hashesOf(aboard("run1.echotrail"), LogUse::Resting));
}

TEST_F(KeptRecordings, ATrackerThatDoesNotRecordSaysSo) {
    LiveRunner runner({}, 0, nullptr);
    HeadLink head(parseLiveAddresses("simulation://demo", "").value(), {}, runner);
    TrackerService service({}, runner, head, "test", RecordingShelf(aboard(""), ""));
    auto link = console(service.start(at(0)).value().port);
    EXPECT_TRUE(becomes([&] { return record(*link).error.find("not recorded aboard") != std::string::npos; }));
    EXPECT_TRUE(link->state().up);
}

}  // namespace
}  // namespace echotrail
