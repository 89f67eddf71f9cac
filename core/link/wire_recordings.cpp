#include "core/link/link_limits.hpp"
#include "core/link/wire_values.hpp"

#include <algorithm>

namespace echotrail {
namespace {

bool isRow(std::int64_t row) { return row >= 0 && row < std::int64_t{1} << 48; }

std::optional<LogRow> read(const wire::Rows::Row& in, LogTable table) {
    if (static_cast<std::size_t>(in.numbers_size()) != numbersOf(table) || !isRow(in.row()) ||
        in.payload().size() > link_limits::longest_payload)
        return std::nullopt;
    LogRow row;
    row.row = in.row();
    std::copy(in.numbers().begin(), in.numbers().end(), row.numbers.begin());
    row.crc = in.crc();
    row.payload.assign(in.payload().begin(), in.payload().end());
    return row;
}

}  // namespace

void write(const LinkRecordings& recordings, wire::Recordings& out) {
    out.set_request(recordings.request);
    for (std::size_t i = 0; i < std::min(recordings.entries.size(), link_limits::most_recordings); ++i) {
        const LinkRecordingEntry& entry = recordings.entries[i];
        wire::Recordings::Entry& each = *out.add_entries();
        each.set_name(entry.name);
        each.set_bytes(entry.bytes);
        each.set_changed_us(microsecondsOf(entry.changed));
        each.set_written(entry.written);
    }
}

std::optional<LinkRecordings> read(const wire::Recordings& in) {
    if (static_cast<std::size_t>(in.entries_size()) > link_limits::most_recordings) return std::nullopt;
    LinkRecordings recordings{in.request(), {}};
    for (const wire::Recordings::Entry& each : in.entries()) {
        const auto changed = timeFrom(each.changed_us());
        // A name that would have to be changed to be shown could not be asked for.
        if (!changed || each.name() != cleanText(each.name(), link_limits::longest_word)) return std::nullopt;
        recordings.entries.push_back({each.name(), each.bytes(), *changed, each.written()});
    }
    return recordings;
}

void write(const LinkRecording& recording, wire::Recording& out) {
    const LogHeader& header = recording.log.header;
    out.set_request(recording.request);
    out.set_name(recording.name);
    out.set_program_version(header.program_version);
    out.set_head(header.head);
    out.set_configuration(header.configuration);
    out.set_seed(header.seed);
    out.set_started_us(microsecondsOf(header.started));
    for (const LogExtent& extent : recording.log.parts) {
        wire::Recording::Extent& each = *out.add_parts();
        each.set_events(extent.events);
        each.set_results(extent.results);
    }
}

std::optional<LinkRecording> read(const wire::Recording& in) {
    const auto started = timeFrom(in.started_us());
    const auto parts = static_cast<std::size_t>(in.parts_size());
    if (!started || parts == 0 || parts > link_limits::most_parts ||
        in.name() != cleanText(in.name(), link_limits::longest_word) ||
        in.program_version().size() > link_limits::longest_text || in.head().size() > link_limits::longest_text ||
        in.configuration().size() > link_limits::longest_configuration)
        return std::nullopt;
    LinkRecording recording{
        in.request(), in.name(), {{in.program_version(), in.head(), in.configuration(), in.seed(), *started}, {}}};
    for (const wire::Recording::Extent& each : in.parts()) {
        if (!isRow(each.events()) || !isRow(each.results())) return std::nullopt;
        recording.log.parts.push_back({each.events(), each.results()});
    }
    return recording;
}

void write(const LinkRows& rows, wire::Rows& out) {
    out.set_request(rows.request);
    out.set_there(rows.rows.there);
    out.set_parts(static_cast<std::uint32_t>(std::max(rows.rows.parts, 0)));
    out.set_table(static_cast<wire::LogTable>(rows.rows.table));
    for (const LogRow& row : rows.rows.rows) {
        wire::Rows::Row& each = *out.add_rows();
        each.set_row(row.row);
        each.set_crc(row.crc);
        each.set_payload(row.payload.data(), row.payload.size());
        for (std::size_t i = 0; i < numbersOf(rows.rows.table); ++i) each.add_numbers(row.numbers[i]);
    }
}

std::optional<LinkRows> read(const wire::Rows& in) {
    if (!isRow(in.there()) || in.parts() > link_limits::most_parts || !wire::LogTable_IsValid(in.table()))
        return std::nullopt;
    const auto table = static_cast<LogTable>(in.table());
    LinkRows rows{in.request(), {table, {}, in.there(), static_cast<int>(in.parts())}};
    for (const wire::Rows::Row& each : in.rows()) {
        auto row = read(each, table);
        if (!row) return std::nullopt;
        rows.rows.rows.push_back(*std::move(row));
    }
    return rows;
}

void write(const LinkReadRows& wanted, wire::ReadRows& out) {
    out.set_recording(wanted.recording);
    out.set_part(static_cast<std::uint32_t>(wanted.rows.part));
    out.set_table(static_cast<wire::LogTable>(wanted.rows.table));
    out.set_first(wanted.rows.first);
    out.set_last(wanted.rows.last);
    out.set_most_bytes(static_cast<std::uint32_t>(wanted.rows.most_bytes));
}

std::optional<LinkReadRows> read(const wire::ReadRows& in) {
    if (in.recording().size() > link_limits::longest_word || in.part() > link_limits::most_parts ||
        !wire::LogTable_IsValid(in.table()) || !isRow(in.first()) || !isRow(in.last()))
        return std::nullopt;
    return LinkReadRows{in.recording(),
                        {static_cast<int>(in.part()), static_cast<LogTable>(in.table()), in.first(), in.last(),
                         std::clamp<std::size_t>(in.most_bytes(), 1, link_limits::longest_rows)}};
}

}  // namespace echotrail
