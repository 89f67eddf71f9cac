#include "core/recording/log_recovery.hpp"

#include "core/recording/file_reader.hpp"
#include "core/recording/log_reader.hpp"
#include "core/recording/log_writer.hpp"
#include "core/recording/row_finder.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <tuple>

namespace echotrail {
namespace {

/// Where a row lies, and its place among the others.
struct Place {
    std::int32_t part = 0;   ///< of a result; events are numbered over all parts
    std::int32_t chunk = 0;  ///< of an event
    std::int64_t order = 0;  ///< of an event its number, of a result its row
    std::uint32_t file = 0;
    std::uint64_t offset = 0;

    auto rank() const { return std::tuple(part, order, chunk); }
};

using SessionRows = std::map<std::int64_t, std::pair<std::string, std::string>>;  // by row number: key, value

std::string valueOf(const SessionRows& session, const std::string& key) {
    std::string value;
    for (const auto& [row, entry] : session)
        if (entry.first == key) value += entry.second;
    return value;
}

bool isWhole(const SessionRows& session) {
    // The part is written last.
    return !session.empty() && session.rbegin()->second.first == "part" &&
           session.rbegin()->first == static_cast<std::int64_t>(session.size());
}

template <class Number>
Number numberOf(const std::string& text) {
    Number number{};
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// Whether a part or its write-ahead log ends before it should.
bool isCut(FileReader& file, bool is_wal) {
    constexpr std::size_t wal_header = 32, frame_header = 24, pages_at = 28;
    if (is_wal)
        return file.size() > 0 &&
               (file.size() < wal_header || (file.size() - wal_header) % (frame_header + log_format::page_bytes) != 0);
    const auto count = file.read(pages_at, 4);
    if (count.size() < 4) return true;
    std::uint64_t pages = 0;
    for (const std::uint8_t byte : count) pages = pages << 8 | byte;
    return file.size() % log_format::page_bytes != 0 || file.size() / log_format::page_bytes < pages;
}

/// One part with its write-ahead log, row by row.
struct ScannedPart {
    SessionRows session;
    std::vector<Place> events, results;
    bool is_log = false;  ///< by its first bytes or by a row
    bool cut = false;
};

class Recovery {
public:
    Result<RecoveryCounts> run(const std::string& in_path, const std::string& out_path);

private:
    ScannedPart scan(const std::string& path, int part);
    void scanFile(const std::string& path, int part, bool is_wal, ScannedPart& found);
    void take(ScannedPart part);
    FoundRow rowOf(const Place& place);
    Result<void> writeEvents(LogWriter& log);
    Result<void> writeResults(LogWriter& log);

    std::vector<FileReader> files_;
    SessionRows session_;
    std::vector<Place> events_, results_;
    RecoveryCounts counts_;
};

ScannedPart Recovery::scan(const std::string& path, int part) {
    ScannedPart found;
    for (const bool is_wal : {false, true}) scanFile(path + (is_wal ? "-wal" : ""), part, is_wal, found);
    return found;
}

void Recovery::scanFile(const std::string& path, int part, bool is_wal, ScannedPart& found) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return;
    FileReader& file = files_.emplace_back(std::move(stream));
    const auto index = static_cast<std::uint32_t>(files_.size() - 1);
    found.cut |= isCut(file, is_wal);
    const auto first = file.read(0, 100);
    found.is_log |= LogReader::isLog({reinterpret_cast<const char*>(first.data()), first.size()});
    for (std::uint64_t offset = 0; offset < file.size();) {
        const auto row = rowAt(file.read(offset, longest_row + 32));
        if (!row) {
            ++offset;
            continue;
        }
        found.is_log = true;
        if (row->table == FoundRow::Table::Session)
            found.session[row->row] = {std::string(row->key), {row->payload.begin(), row->payload.end()}};
        else if (row->table == FoundRow::Table::Results)
            found.results.push_back({part, 0, row->row, index, offset});
        else
            found.events.push_back({0, static_cast<std::int32_t>(row->numbers[4]), row->numbers[0], index, offset});
        offset += row->bytes;
    }
}

void Recovery::take(ScannedPart part) {
    ++counts_.parts;
    counts_.cut |= part.cut;
    events_.insert(events_.end(), part.events.begin(), part.events.end());
    results_.insert(results_.end(), part.results.begin(), part.results.end());
    if (session_.empty()) session_ = std::move(part.session);
}

/// Rows of a page lie from its end to its beginning: it is read as a whole.
FoundRow Recovery::rowOf(const Place& place) {
    const std::uint64_t page = place.offset - place.offset % longest_row;
    const auto bytes = files_[place.file].read(page, 3 * longest_row);
    const auto row = bytes.size() > place.offset - page ? rowAt(bytes.subspan(place.offset - page)) : std::nullopt;
    return row.value_or(FoundRow{});  // empty where the file has changed since
}

void keepOneOfEach(std::vector<Place>& places) {
    const auto before = [](const Place& a, const Place& b) { return a.rank() < b.rank(); };
    const auto same = [](const Place& a, const Place& b) { return a.rank() == b.rank(); };
    std::stable_sort(places.begin(), places.end(), before);
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
}

Event eventOf(const FoundRow& row) {
    return {static_cast<std::uint64_t>(row.numbers[0]),
            static_cast<EventKind>(row.numbers[1]),
            Timestamp(Microseconds(row.numbers[2])),
            Microseconds(row.numbers[3]),
            {}};
}

Result<void> Recovery::writeEvents(LogWriter& log) {
    constexpr std::uint64_t events_per_commit = 1000;
    keepOneOfEach(events_);
    std::uint64_t expected = 0;
    for (auto at = events_.begin(); at != events_.end();) {
        const auto end = std::find_if(at, events_.end(), [&](const Place& p) { return p.order != at->order; });
        Event event = eventOf(rowOf(*at));
        std::int64_t chunks = 0, wanted = 1;
        for (; at != end; ++at) {
            const FoundRow row = rowOf(*at);
            wanted = row.numbers[5];
            if (row.numbers[4] != chunks) continue;
            event.payload.insert(event.payload.end(), row.payload.begin(), row.payload.end());
            ++chunks;
        }
        const std::uint64_t number = static_cast<std::uint64_t>((end - 1)->order);
        if (chunks != wanted) continue;
        if (auto done = log.add(event); !done) return done;
        counts_.missing_events += number - expected;
        expected = number + 1;
        if (++counts_.events % events_per_commit != 0) continue;
        if (auto done = log.commit(); !done) return done;
    }
    if (!events_.empty()) counts_.missing_events += static_cast<std::uint64_t>(events_.back().order) + 1 - expected;
    return {};
}

Result<void> Recovery::writeResults(LogWriter& log) {
    keepOneOfEach(results_);
    for (const Place& place : results_) {
        const FoundRow row = rowOf(place);
        const std::string text(row.payload.begin(), row.payload.end());
        const Timestamp time{Microseconds(row.numbers[1])};
        if (auto done = log.addUpdate(static_cast<UpdateKind>(row.numbers[0]), time, text); !done) return done;
        ++counts_.results;
    }
    return {};
}

LogHeader headerOf(const SessionRows& session) {
    LogHeader header;
    header.program_version = valueOf(session, "program_version");
    header.head = valueOf(session, "head");
    header.configuration = valueOf(session, "configuration");
    header.seed = numberOf<std::uint64_t>(valueOf(session, "seed"));
    header.started = Timestamp(Microseconds(numberOf<std::int64_t>(valueOf(session, "started_us"))));
    return header;
}

/// Whether the log gives all that was recovered of it without a complaint.
bool isReadable(const std::string& path, const RecoveryCounts& counts) {
    auto reader = LogReader::open(path);
    if (!reader) return false;
    std::uint64_t events = 0, results = 0;
    while ((*reader)->next()) ++events;
    while ((*reader)->nextResult()) ++results;
    // There may be more than it gives: of a commit that a killed process had begun.
    return !(*reader)->counts().any() && events <= counts.events && results <= counts.results;
}

Result<RecoveryCounts> Recovery::run(const std::string& in_path, const std::string& out_path) {
    ScannedPart named = scan(in_path, 0);
    if (files_.empty()) return Error{"cannot recover " + in_path + ": no such file, or it cannot be read"};
    if (!named.is_log) return Error{"cannot recover " + in_path + ": it is not an Echotrail log"};
    const std::string started = valueOf(named.session, "started_us");
    const int part = numberOf<int>(valueOf(named.session, "part"));
    session_ = named.session;
    for (const auto& [number, path] : log_format::partsBeside(log_format::firstPartPath(in_path, part))) {
        if (path == in_path) continue;
        ScannedPart other = scan(path, number);
        const std::string other_started = valueOf(other.session, "started_us");
        if (other_started.empty() || started.empty() || other_started == started) take(std::move(other));
    }
    for (Place& place : named.results) place.part = part;
    take(std::move(named));
    counts_.header_found = isWhole(session_);
    auto log = LogWriter::create(out_path, headerOf(session_));
    if (!log) return Error{log.error()};
    if (auto done = writeEvents(**log); !done) return Error{done.error()};
    if (auto done = writeResults(**log); !done) return Error{done.error()};
    if (auto done = (*log)->close(); !done) return Error{done.error()};
    counts_.was_readable = isReadable(in_path, counts_);
    return counts_;
}

}  // namespace

Result<RecoveryCounts> recover(const std::string& in_path, const std::string& out_path) {
    return Recovery().run(in_path, out_path);
}

}  // namespace echotrail
