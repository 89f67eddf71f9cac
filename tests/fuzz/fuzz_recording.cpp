#include "core/recording/recording.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// Any file: it opens or is refused in one line; twice through, the same pings come in the order of their times.
namespace {

void require(bool law, const char* what) {
    if (law) return;
    std::fprintf(stderr, "broken law: %s\n", what);
    std::abort();
}

std::vector<echotrail::Ping> pingsOf(echotrail::PingSource& source) {
    std::vector<echotrail::Ping> pings;
    while (auto ping = source.next()) {
        require(pings.empty() || pings.back().time <= ping->time, "times rise");
        require(ping->sequence == pings.size(), "pings are numbered");
        pings.push_back(std::move(*ping));
    }
    return pings;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string path =
        std::filesystem::temp_directory_path() / ("fuzz-recording-" + std::to_string(getpid()));
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    const auto source = echotrail::openRecording(path);
    if (!source) {
        require(source.error().find('\n') == std::string::npos, "errors are one line");
        return 0;
    }
    const auto first = pingsOf(**source);
    const auto lost = (*source)->counts().lost_records;
    require(first.size() == (*source)->info().pings, "the survey counts the pings");
    require((*source)->counts().skipped_bytes <= size, "no more is skipped than is there");
    (*source)->rewind();
    require(pingsOf(**source) == first, "rewound, the same pings");
    require((*source)->counts().lost_records == lost, "rewound, the same counts");
    return 0;
}
