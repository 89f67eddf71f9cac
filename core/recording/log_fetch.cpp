#include "core/recording/log_fetch.hpp"

#include <algorithm>

namespace echotrail {
namespace {

constexpr std::size_t most_parts = 10'000;  // as their names have four digits

std::size_t indexOf(LogTable table) { return static_cast<std::size_t>(table); }

Result<void> wereAskedFor(const LogRowsWanted& wanted, const LogRows& rows) {
    if (rows.table != wanted.table) return Error{"rows came of a table that was not asked for"};
    std::int64_t before = wanted.first - 1;
    for (const LogRow& row : rows.rows) {
        if (row.row <= before || row.row > wanted.last)
            return Error{"rows came that were not asked for, from " + std::to_string(row.row)};
        before = row.row;
    }
    return {};
}

LogTable other(LogTable table) { return table == LogTable::Events ? LogTable::Results : LogTable::Events; }

}  // namespace

LogFetch::LogFetch(std::unique_ptr<LogCopy> copy, const LogDescription& there, bool newest_first)
    : copy_(std::move(copy)) {
    for (const LogExtent& extent : there.parts) parts_.push_back({extent, {1, 1}, {true, true}});
    if (parts_.empty()) parts_.emplace_back();
    parts_.back().settled = {false, false};
    if (!newest_first) return;
    // A copy that was begun before goes on where its newest rows begin; another one now.
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (const LogTable table : log_tables) {
            const RowRanges& held = copy_->held(static_cast<int>(part), table);
            const bool begun = held.count() > 0;
            parts_[part].begins.of(table) = begun ? held.lastBegins() : parts_[part].there.of(table) + 1;
        }
    // What came in a later part than the newest rows here has been missed, all of it.
    bool later = false;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        const bool begun = copy_->held(static_cast<int>(part), LogTable::Events).count() > 0;
        if (later && !begun) parts_[part].begins = {1, 1};
        later |= begun;
    }
}

std::optional<LogRowsWanted> LogFetch::missingFrom(bool the_newer, std::size_t most_bytes) {
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (const LogTable table : log_tables) {
            const std::int64_t from = the_newer ? parts_[part].begins.of(table) : 1;
            const auto range = copy_->held(static_cast<int>(part), table).missing(from, parts_[part].there.of(table));
            if (range) return LogRowsWanted{static_cast<int>(part), table, range->first, range->second, most_bytes};
        }
    return std::nullopt;
}

std::optional<LogRowsWanted> LogFetch::next(std::size_t most_bytes) {
    const auto wanted = missingFrom(true, most_bytes);
    return wanted ? wanted : missingFrom(false, most_bytes);
}

LogRowsWanted LogFetch::lookForMore(std::size_t most_bytes) {
    constexpr std::int64_t any_number = 1'000'000;
    auto part = parts_.begin();
    while (part + 1 != parts_.end() && part->settled[0] && part->settled[1]) ++part;
    if (part->settled[indexOf(turn_)]) turn_ = other(turn_);
    const LogTable table = std::exchange(turn_, other(turn_));
    const std::int64_t after = part->there.of(table) + 1;
    // From one row to the one before it: only how far they are.
    const std::int64_t last = table == LogTable::Results ? after - 1 : after + any_number;
    return {static_cast<int>(part - parts_.begin()), table, after, last, most_bytes};
}

Result<void> LogFetch::take(const LogRowsWanted& wanted, const LogRows& rows) {
    if (auto asked = wereAskedFor(wanted, rows); !asked) return asked;
    const auto parts = std::min(static_cast<std::size_t>(std::max(rows.parts, 0)), most_parts);
    if (parts > parts_.size()) parts_.resize(parts);
    Part& part = parts_.at(static_cast<std::size_t>(wanted.part));
    if (rows.parts > wanted.part + 1) part.settled[indexOf(wanted.table)] = true;
    if (wanted.table == LogTable::Results && wanted.last < wanted.first) {
        part.results_seen = rows.there;
        if (part.settled[indexOf(LogTable::Events)]) part.there.results = rows.there;
        return {};
    }
    if (wanted.table == LogTable::Events) part.there.results = std::max(part.there.results, part.results_seen);
    std::int64_t& there = part.there.of(wanted.table);
    if (!rows.rows.empty()) {
        if (wanted.table == LogTable::Events) there = std::max(there, rows.there);
        there = std::max(there, rows.rows.back().row);
        return copy_->add(wanted, rows.rows);
    }
    // Nothing where rows were said to be: the log aboard has a hole there, or has become shorter. Not to be asked
    // again.
    if (wanted.last <= rows.there)
        copy_->passOver(wanted);
    else
        there = std::max(rows.there, copy_->held(wanted.part, wanted.table).last());
    return {};
}

LogFetch::Progress LogFetch::progress() const {
    Progress progress;
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (const LogTable table : log_tables) {
            const RowRanges& held = copy_->held(static_cast<int>(part), table);
            progress.rows += held.count();
            progress.there += std::max(parts_[part].there.of(table), held.last());
            std::int64_t from = parts_[part].begins.of(table);
            while (const auto range = held.missing(from, parts_[part].there.of(table))) {
                progress.missed += range->second - range->first + 1;
                from = range->second + 1;
            }
        }
    return progress;
}

}  // namespace echotrail
