#include "program.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace echotrail {

namespace {

TEST(Fences, EchotrailLinksNothingOfQtGui) {
    const ScratchFolder folder;
    const std::string command = std::string("ldd '") + ECHOTRAIL_PROGRAM + "' > '" + folder.path("libraries") + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const std::string libraries = contentOf(folder.path("libraries"));
    EXPECT_NE(libraries.find("libopencv_core"), std::string::npos) << "not a list of libraries: " << libraries;
    for (const char* gui : {"Qt6Gui", "Qt6Widgets"}) EXPECT_EQ(libraries.find(gui), std::string::npos) << gui;
}

TEST(Fences, NothingUnderCoreIncludesAQtHeader) {
    int files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(ECHOTRAIL_CORE)) {
        const std::string kind = entry.path().extension();
        if (kind != ".hpp" && kind != ".cpp") continue;
        ++files;
        for (const std::string& line : linesOf(contentOf(entry.path()))) {
            const bool qt = line.starts_with("#include") && line.find("<Q") != std::string::npos;
            EXPECT_FALSE(qt) << entry.path() << ": " << line;
        }
    }
    EXPECT_GT(files, 50);
}

}  // namespace

}  // namespace echotrail
