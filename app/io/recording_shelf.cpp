#include "app/io/recording_shelf.hpp"

#include "core/link/link_limits.hpp"
#include "core/recording/log_format.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace echotrail {
namespace {

namespace fs = std::filesystem;

/// The path of the first part, whichever part this is; itself where there is no such file.
std::string firstPartOf(const std::string& path) {
    const std::string stem = path.substr(0, path.size() - log_format::suffix.size());
    int part = 0;
    if (const auto dash = stem.find_last_of('-'); dash != std::string::npos)
        std::from_chars(stem.data() + dash + 1, stem.data() + stem.size(), part);
    std::string first = log_format::firstPartPath(path, part);
    std::error_code failure;
    return fs::is_regular_file(first, failure) ? first : path;
}

Timestamp changedOf(const std::string& path) {
    std::error_code failure;
    const auto changed = fs::last_write_time(path, failure);
    if (failure) return {};
    return std::chrono::time_point_cast<Microseconds>(std::chrono::file_clock::to_sys(changed));
}

/// Fit for one line, and not to be mistaken for a path.
bool isName(const std::string& name) {
    return name.size() <= link_limits::longest_word && std::all_of(name.begin(), name.end(), [](char c) {
               return c != '/' && static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7F;
           });
}

}  // namespace

RecordingShelf::RecordingShelf(std::string folder, std::string written)
    : folder_(std::move(folder)), written_(std::move(written)) {
    list();
}

void RecordingShelf::add(const std::string& path, std::vector<LinkRecordingEntry>& entries) {
    const std::string name = fs::path(path).filename().string();
    if (!isName(name) || paths_.contains(name)) return;
    LinkRecordingEntry entry{name, 0, {}, path == written_};
    for (const auto& [part, part_path] : log_format::partsBeside(path))
        for (const char* beside : {"", "-wal"}) {
            std::error_code failure;
            const auto bytes = fs::file_size(part_path + beside, failure);
            if (failure) continue;
            entry.bytes += bytes;
            entry.changed = std::max(entry.changed, changedOf(part_path + beside));
        }
    paths_[name] = path;
    entries.push_back(std::move(entry));
}

/// A name that is on the shelf already stands for what was there first.
void RecordingShelf::addFolder(const std::string& folder, std::vector<LinkRecordingEntry>& entries) {
    std::error_code failure;
    for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
        std::error_code unknown;
        const std::string path = entry->path().string();
        // A link would lead elsewhere.
        if (!fs::is_regular_file(entry->symlink_status(unknown)) || !path.ends_with(log_format::suffix)) continue;
        if (firstPartOf(path) == path) add(path, entries);
    }
}

std::vector<LinkRecordingEntry> RecordingShelf::list() {
    paths_.clear();
    std::vector<LinkRecordingEntry> entries;
    if (!written_.empty()) {
        add(written_, entries);
        const fs::path beside = fs::path(written_).parent_path();
        addFolder(beside.empty() ? "." : beside.string(), entries);
    }
    addFolder(folder_, entries);
    std::sort(entries.begin(), entries.end(), [](const LinkRecordingEntry& a, const LinkRecordingEntry& b) {
        return std::pair(a.written, a.changed) > std::pair(b.written, b.changed);
    });
    if (entries.size() > link_limits::most_recordings) entries.resize(link_limits::most_recordings);
    return entries;
}

Result<RecordingShelf::Place> RecordingShelf::find(const std::string& name) const {
    if (name.empty()) {
        if (written_.empty()) return Error{"this run is not recorded aboard"};
        return Place{written_, LogUse::Written};
    }
    const auto found = paths_.find(name);
    if (found == paths_.end()) return Error{"there is no recording of that name; ask for the list"};
    return Place{found->second, found->second == written_ ? LogUse::Written : LogUse::Resting};
}

Result<LinkRecordAnswer> RecordingShelf::answer(const LinkRecordRequest& request) {
    if (std::holds_alternative<LinkListRecordings>(request.content)) return LinkRecordAnswer(LinkRecordings{0, list()});
    const auto* described = std::get_if<LinkDescribeRecording>(&request.content);
    const auto* wanted = std::get_if<LinkReadRows>(&request.content);
    const auto place = find(described ? described->recording : wanted->recording);
    if (!place) return Error{place.error()};
    if (described) {
        auto log = describeLog(place->path, place->use);
        if (!log) return Error{log.error()};
        if (log->header.configuration.size() > link_limits::longest_configuration)
            return Error{"its parameters are too long for the link"};
        return LinkRecordAnswer(LinkRecording{0, fs::path(place->path).filename().string(), *std::move(log)});
    }
    auto rows = readLogRows(place->path, place->use, wanted->rows);
    if (!rows) return Error{rows.error()};
    return LinkRecordAnswer(LinkRows{0, *std::move(rows)});
}

}  // namespace echotrail
