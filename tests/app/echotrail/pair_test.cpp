#include "program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace echotrail {
namespace {

/// What this machine trusts lies in a folder of the test.
class PairProgram : public testing::Test {
protected:
    PairProgram() { setenv("XDG_DATA_HOME", folder_.path("data").c_str(), 1); }
    ~PairProgram() override { unsetenv("XDG_DATA_HOME"); }
    ScratchFolder folder_;
};

TEST_F(PairProgram, BothSidesAreListedAndRevoked) {
    const std::string out = folder_.path("aboard");
    // Aboard it says its code and port; the console is told both. One user is both machines here.
    const std::string script = folder_.write("script", R"(
        "$1" pair --serve tls://127.0.0.1:0 --name vehicle > "$2" &
        for i in $(seq 300); do grep -q tls: "$2" && break; sleep 0.1; done
        code=$(sed -n 's/The code is \([^;]*\);.*/\1/p' "$2")
        port=$(sed -n 's/.*tls:.*:\([0-9]*\)$/\1/p' "$2")
        echo $code | "$1" pair tls://127.0.0.1:$port --name shore && wait $!)");
    const std::string command = "sh '" + script + "' '" + ECHOTRAIL_PROGRAM + "' '" + out + "' > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << contentOf(out);
    const Outcome listed = run({"pair", "--list"});
    EXPECT_EQ(listed.exit_code, 0);
    ASSERT_EQ(linesOf(listed.output).size(), 2U) << listed.output;
    EXPECT_TRUE(linesOf(listed.output)[0].starts_with("console  "));
    EXPECT_TRUE(linesOf(listed.output)[0].ends_with("  shore"));
    EXPECT_TRUE(linesOf(listed.output)[1].starts_with("tracker  "));
    EXPECT_EQ(run({"pair", "--revoke", "shore"}).exit_code, 0);
    EXPECT_EQ(linesOf(run({"pair", "--list"}).output).size(), 1U);
    const Outcome again = run({"pair", "--revoke", "shore"});
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_TRUE(isOneLine(again.errors)) << again.errors;
}

TEST_F(PairProgram, WrongUsageIsSaidInOneLine) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"pair", "tcp://127.0.0.1:1"},
                                                      {"pair", "vehicle"},
                                                      {"pair", "tls://127.0.0.1:1", "--list", "--revoke", "x"}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.errors;
        EXPECT_TRUE(isOneLine(outcome.errors)) << outcome.errors;
    }
}

}  // namespace
}  // namespace echotrail
