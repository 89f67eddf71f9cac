#pragma once

#include "core/link/link_values.hpp"
#include "core/recording/log_extract.hpp"

#include <map>
#include <string>
#include <vector>

namespace echotrail {

/// The recordings that consoles may read: the logs of a folder, and the one that is being written, wherever it lies.
/// Each is known by a name of the list and by nothing else: no path is ever made of what a console says.
/// Threads: none; one owner calls it.
class RecordingShelf {
public:
    /// `written`: path of the log that this program writes; empty: none. What lies in its folder is on the shelf, too:
    /// a run that was cut off there is to be had when the next one is written beside it.
    RecordingShelf(std::string folder, std::string written);

    /// The newest first, as the folders are now.
    std::vector<LinkRecordingEntry> list();
    Result<LinkRecordAnswer> answer(const LinkRecordRequest& request);

private:
    struct Place {
        std::string path;  ///< of the first part
        LogUse use = LogUse::Resting;
    };
    Result<Place> find(const std::string& name) const;
    void add(const std::string& path, std::vector<LinkRecordingEntry>& entries);
    void addFolder(const std::string& folder, std::vector<LinkRecordingEntry>& entries);

    std::string folder_, written_;
    std::map<std::string, std::string> paths_;  ///< by name, as last listed
};

}  // namespace echotrail
