#include "tracks_writer.hpp"

#include "core/tracking/track_text.hpp"

#include <cerrno>
#include <cstring>
#include <iostream>

namespace echotrail {

namespace {

/// The same numbers in the order of the line, the covariance in three columns.
std::string csvRow(const nlohmann::ordered_json& line) {
    std::string row;
    const auto append = [&](const nlohmann::ordered_json& value) {
        if (!row.empty()) row += ',';
        row += value.is_string() ? value.get<std::string>() : value.dump();
    };
    for (const auto& value : line)
        if (value.is_array())
            for (const auto& element : value) append(element);
        else
            append(value);
    return row;
}

constexpr std::string_view csv_header =
    "time,t,track,state,target,range_m,bearing_deg,north_m,east_m,velocity_north_mps,velocity_east_mps,"
    "covariance_nn_m2,covariance_ne_m2,covariance_ee_m2,seen,cause";

}  // namespace

Result<std::unique_ptr<TracksWriter>> TracksWriter::open(const std::string& path, TracksFormat format) {
    std::unique_ptr<TracksWriter> writer(new TracksWriter(path, format));
    if (path == "-") {
        writer->out_ = &std::cout;
        return writer;
    }
    errno = 0;
    writer->file_.open(path);
    if (!writer->file_) return Error{"cannot write " + path + ": " + std::strerror(errno)};
    writer->out_ = &writer->file_;
    if (format == TracksFormat::Csv) writer->file_ << csv_header << '\n';
    return writer;
}

Result<void> TracksWriter::add(const Update& update, Timestamp settled) {
    for (const TrackLook& look : update.looks) {
        if (written_until_ && look.time < *written_until_)
            ++late_;
        else
            held_.emplace(look.time, look);
    }
    return writeUntil(settled - Microseconds(1));
}

Result<void> TracksWriter::writeUntil(Timestamp time) {
    const std::size_t before = held_.size();
    while (!held_.empty() && held_.begin()->first <= time) {
        written_until_ = held_.begin()->first;
        const auto line = trackLine(held_.begin()->second, first_ping_);
        *out_ << (format_ == TracksFormat::Csv ? csvRow(line) : line.dump()) << '\n';
        held_.erase(held_.begin());
    }
    if (held_.size() != before) out_->flush();  // whoever reads along shall not wait for a full buffer
    if (!*out_) return Error{"cannot write " + (path_ == "-" ? "standard output" : path_) + ": it takes no more"};
    return {};
}

Result<void> TracksWriter::finish(const nlohmann::ordered_json& summary) {
    if (auto written = writeUntil(Timestamp::max()); !written) return written;
    if (format_ == TracksFormat::JsonLines) *out_ << nlohmann::ordered_json{{"summary", summary}}.dump() << '\n';
    out_->flush();
    return writeUntil(Timestamp::max());
}

}  // namespace echotrail
