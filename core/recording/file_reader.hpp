#pragma once

#include "core/seanet/bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace echotrail {

/// Random access to a file by small pieces, from a window that moves along: a damaged stretch is searched byte by
/// byte, and a system call for each would take minutes.
class FileReader {
public:
    explicit FileReader(std::ifstream file) : file_(std::move(file)) {
        file_.clear();
        file_.seekg(0, std::ios::end);
        size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(file_.tellg(), 0));
    }
    std::uint64_t size() const { return size_; }

    /// Up to `count` bytes from `offset`; fewer at the end of the file. Valid until the next call.
    seanet::Bytes read(std::uint64_t offset, std::size_t count) {
        if (offset >= size_) return {};
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - offset));
        if (offset < begin_ || offset + wanted > begin_ + window_.size()) load(offset, std::max(wanted, window_bytes));
        if (offset >= begin_ + window_.size()) return {};
        const auto at = static_cast<std::size_t>(offset - begin_);
        return seanet::Bytes(window_).subspan(at, std::min(wanted, window_.size() - at));
    }

private:
    static constexpr std::size_t window_bytes = 1 << 16;

    void load(std::uint64_t offset, std::size_t bytes) {
        begin_ = offset;
        window_.resize(bytes);
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(offset));
        file_.read(reinterpret_cast<char*>(window_.data()), static_cast<std::streamsize>(bytes));
        window_.resize(static_cast<std::size_t>(file_.gcount()));
    }

    std::ifstream file_;
    std::uint64_t size_ = 0;
    std::uint64_t begin_ = 0;  ///< of the window
    std::vector<std::uint8_t> window_;
};

/// The file's own name, without its folders.
inline std::string fileName(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace echotrail
