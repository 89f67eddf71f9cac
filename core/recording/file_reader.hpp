#pragma once

#include "core/seanet/bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace echotrail {

/// Random access to a file by small pieces.
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
        buffer_.resize(offset >= size_ ? 0 : static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - offset)));
        if (buffer_.empty()) return {};
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(offset));
        file_.read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(buffer_.size()));
        buffer_.resize(static_cast<std::size_t>(file_.gcount()));
        return buffer_;
    }

private:
    std::ifstream file_;
    std::uint64_t size_ = 0;
    std::vector<std::uint8_t> buffer_;
};

/// The file's own name, without its folders.
inline std::string fileName(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace echotrail
