#pragma once

#include "core/seanet/frame_parser.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace echotrail {

using ByteVector = std::vector<std::uint8_t>;

/// A capture by its path in the folder of shared recordings; empty where there is none.
inline std::string sharedCapture(const std::string& name) {
    const std::string path = std::string(ECHOTRAIL_SHARED_DATA) + "/seanet/" + name;
    return std::filesystem::exists(path) ? path : std::string();
}

inline ByteVector readBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The bytes of a text of hex pairs with comment lines.
inline ByteVector readHex(const std::string& path) {
    std::ifstream file(path);
    ByteVector bytes;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream pairs(line);
        for (std::string pair; pairs >> pair;) bytes.push_back(static_cast<std::uint8_t>(std::stoi(pair, nullptr, 16)));
    }
    return bytes;
}

inline ByteVector joined(std::initializer_list<ByteVector> parts) {
    ByteVector all;
    for (const ByteVector& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace echotrail
