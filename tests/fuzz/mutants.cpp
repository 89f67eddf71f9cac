#include "core/base/random.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// A fuzzer's entry without libFuzzer: every input of a corpus, and so many mutants of them, the same on every run.
//   mutants CORPUS COUNT

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace echotrail {
namespace {

constexpr std::size_t longest = 4096;
constexpr std::uint32_t most_changes = 6;

std::vector<std::string> inputsOf(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> inputs;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return inputs;
}

std::string mutant(const std::vector<std::string>& inputs, RandomStream& random) {
    const auto below = [&](std::size_t limit) { return limit == 0 ? 0 : random.bits() % limit; };
    std::string text = inputs[below(inputs.size())];
    for (std::size_t left = 1 + below(most_changes); left > 0; --left) {
        const std::size_t at = below(text.size() + 1), length = below(16);
        const std::string& other = inputs[below(inputs.size())];
        switch (below(6)) {
            case 0:
                if (at < text.size()) text[at] ^= static_cast<char>(1U << below(8));
                break;
            case 1:
                if (at < text.size()) text[at] = static_cast<char>(random.bits());
                break;
            case 2:
                text.insert(at, length, static_cast<char>(random.bits()));
                break;
            case 3:
                text.erase(at, length);
                break;
            case 4:
                text.insert(at, text.substr(below(text.size() + 1), length));
                break;
            default:
                text = text.substr(0, at) + other.substr(below(other.size() + 1));
        }
        if (text.size() > longest) text.resize(longest);
    }
    return text;
}

void run(const std::string& input) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace
}  // namespace echotrail

int main(int argc, char** argv) {
    using namespace echotrail;
    if (argc != 3) {
        std::cerr << "usage: " << argv[0] << " CORPUS COUNT\n";
        return 2;
    }
    const auto inputs = inputsOf(argv[1]);
    const long count = std::strtol(argv[2], nullptr, 10);
    if (inputs.empty() || count <= 0) {
        std::cerr << argv[1] << " holds no inputs, or there is nothing to do\n";
        return 1;
    }
    for (const std::string& input : inputs) run(input);
    RandomStream random(1, 0, 0);
    for (long i = 0; i < count; ++i) run(mutant(inputs, random));
    std::cout << inputs.size() << " inputs and " << count << " mutants of them: no law was broken\n";
    return 0;
}
