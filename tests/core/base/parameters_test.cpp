#include "core/base/parameters.hpp"

#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

namespace echotrail {
namespace {

enum class Colour { Red, Green };
struct Inner {
    double threshold_db = 12.0;
    int hits = 2;
};
struct Outer {
    bool on = false;
    Colour colour = Colour::Green;
};
struct Everything {
    Inner inner;
    Outer outer;
    bool operator==(const Everything&) const = delete;
};

}  // namespace

template <>
struct Described<Inner> {
    static constexpr std::string_view group = "Inner";
    static constexpr auto fields = std::tuple{
        Field{&Inner::threshold_db, "threshold_db", "dB", 3, 40, "How far an echo must stand out"},
        Field{&Inner::hits, "hits", "", 1, 9, "Pings that must meet it", Effect::NextSweep}};
};
template <>
struct Described<Outer> {
    static constexpr std::string_view group = "Outer";
    static constexpr auto fields =
        std::tuple{flag(&Outer::on, "on", "Whether at all"),
                   ChoiceField<Outer, Colour, 2>{&Outer::colour, "colour", {"red", "green"}, "Which"}};
};
template <>
struct Described<Everything> {
    static constexpr auto stages = std::tuple{&Everything::inner, &Everything::outer};
};

namespace {

std::string writeFile(const std::string& text) {
    const std::string path = testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml";
    std::ofstream(path) << text;
    return path;
}

TEST(Parameters, DescriptionCarriesNameUnitLimitsDefaultAndGroup) {
    const auto all = describeParameters<Everything>();
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].name, "threshold_db");
    EXPECT_EQ(all[0].unit, "dB");
    EXPECT_EQ(all[0].group, "Inner");
    EXPECT_EQ(std::get<double>(all[0].default_value), 12.0);
    EXPECT_EQ(all[1].effect, Effect::NextSweep);
    EXPECT_EQ(std::get<std::string>(all[3].default_value), "green");
}

TEST(Parameters, TextSetsTheMember) {
    Everything params;
    EXPECT_TRUE(setParameterFromText(params, "threshold_db=15.5"));
    EXPECT_TRUE(setParameterFromText(params, "hits=3"));
    EXPECT_TRUE(setParameterFromText(params, "on=true"));
    EXPECT_TRUE(setParameterFromText(params, "colour=red"));
    EXPECT_EQ(params.inner.threshold_db, 15.5);
    EXPECT_EQ(params.inner.hits, 3);
    EXPECT_TRUE(params.outer.on);
    EXPECT_EQ(params.outer.colour, Colour::Red);
}

TEST(Parameters, RefusalsSayWhatWouldPassAndChangeNothing) {
    Everything params;
    for (const char* bad : {"threshold_db=41", "threshold_db=nan", "threshold_db=", "threshold_db=12dB", "hits=2.5",
                            "on=maybe", "colour=blue", "nothing", "inf=1"}) {
        const auto set = setParameterFromText(params, bad);
        EXPECT_FALSE(set) << bad;
        EXPECT_EQ(set.error().find('\n'), std::string::npos) << bad;
    }
    EXPECT_EQ(setParameterFromText(params, "threshold_db=41").error(),
              "threshold_db cannot be 41; it takes a number from 3 to 40 dB");
    EXPECT_EQ(setParameterFromText(params, "treshold_db=14").error(),
              "no parameter is called 'treshold_db'; did you mean threshold_db?");
    EXPECT_EQ(params.inner.threshold_db, 12.0);
    EXPECT_EQ(params.inner.hits, 2);
}

TEST(ParameterFile, TablesAreHeadingsOnly) {
    Everything params;
    ASSERT_TRUE(applyParameterFile(params, writeFile("hits = 4\n[anything]\nthreshold_db = 20\ncolour = 'red'\n")));
    EXPECT_EQ(params.inner.hits, 4);
    EXPECT_EQ(params.inner.threshold_db, 20.0);
    EXPECT_EQ(params.outer.colour, Colour::Red);
}

TEST(ParameterFile, ErrorsNameTheLineAndNothingIsApplied) {
    Everything params;
    const std::string path = writeFile("hits = 4\nthreshold_db = 99\n");
    const auto applied = applyParameterFile(params, path);
    ASSERT_FALSE(applied);
    EXPECT_NE(applied.error().find(path + ":2: threshold_db cannot be 99"), std::string::npos) << applied.error();
    EXPECT_EQ(params.inner.hits, 2);
    EXPECT_FALSE(applyParameterFile(params, writeFile("hits = = 4\n")));
    EXPECT_FALSE(applyParameterFile(params, "/nonexistent/file.toml"));
}

TEST(ParameterFile, WrittenTextReadsBackToTheSameValues) {
    Everything params;
    params.inner = {17.25, 5};
    params.outer = {true, Colour::Red};
    const std::string text = parameterFileText(describeParameters<Everything>(), parameterValues(params));
    Everything read;
    ASSERT_TRUE(applyParameterFile(read, writeFile(text)));
    EXPECT_EQ(parameterValues(read), parameterValues(params));
}

}  // namespace
}  // namespace echotrail
