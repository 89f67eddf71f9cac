#include "program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace echotrail {

namespace {

/// So that the shell takes any argument as it is.
std::string quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments) { return runProgram(ECHOTRAIL_PROGRAM, arguments); }

Outcome runProgram(const std::string& program, const std::vector<std::string>& arguments) {
    const ScratchFolder scratch;
    std::string command = "timeout 120 " + quoted(program);
    for (const std::string& argument : arguments) command += " " + quoted(argument);
    command += " >" + quoted(scratch.path("out")) + " 2>" + quoted(scratch.path("err")) + " </dev/null";
    const int status = std::system(command.c_str());
    constexpr int timed_out = 124;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return {code == timed_out ? -1 : code, contentOf(scratch.path("out")), contentOf(scratch.path("err"))};
}

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "echotrail-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;  // a leftover folder is no failure of what is tested
    std::filesystem::remove_all(folder_, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
}

std::string contentOf(const std::string& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

bool isOneLine(const std::string& errors) { return errors.starts_with("echotrail: ") && linesOf(errors).size() == 1; }

}  // namespace echotrail
