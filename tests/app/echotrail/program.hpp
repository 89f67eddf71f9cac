#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace echotrail {

/// What came of one run of echotrail.
struct Outcome {
    int exit_code = -1;  ///< −1: it did not end by itself
    std::string output;  ///< standard output
    std::string errors;  ///< standard error
};

/// Runs echotrail with these arguments; it is ended after two minutes.
Outcome run(const std::vector<std::string>& arguments);
/// The same with another build of it.
Outcome runProgram(const std::string& program, const std::vector<std::string>& arguments);

/// A folder for one test's files, gone afterwards.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& content) const;

private:
    std::filesystem::path folder_;
};

std::string contentOf(const std::string& path);

/// Lines without their line ends.
std::vector<std::string> linesOf(const std::string& text);

/// One line that begins with the program's name: what every failure says.
bool isOneLine(const std::string& errors);

}  // namespace echotrail
