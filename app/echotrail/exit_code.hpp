#pragma once

#include <iostream>
#include <string_view>

namespace echotrail {

/// How a command ends, as other programs read it.
enum class ExitCode {
    Done = 0,
    Failed = 1,  ///< while running; one line on standard error says why
    Usage = 2,   ///< the command line asks for something that is not there
    Lossy = 3,   ///< done, but something of the source was lost
};

/// Says in one line what is wrong.
inline ExitCode fail(ExitCode code, std::string_view reason) {
    std::cerr << "echotrail: " << reason << "\n";
    return code;
}

}  // namespace echotrail
