#include "colour_measures.hpp"
#include "ui/style/echo_map.hpp"
#include "ui/style/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace echotrail {
namespace {

using test::colourDifference;
using test::contrast;

constexpr std::array all_themes{Theme::Day, Theme::Dusk, Theme::Night};

TEST(ColourMeasures, AgreeWithPublishedValues) {
    EXPECT_NEAR(contrast(QColor(QRgb{0xff000000}), QColor(QRgb{0xffffffff})), 21.0, 1e-9);
    EXPECT_NEAR(colourDifference(QColor(QRgb{0xff000000}), QColor(QRgb{0xffffffff})), 100.0, 1e-3);
    EXPECT_EQ(colourDifference(QColor(QRgb{0xff35c8ff}), QColor(QRgb{0xff35c8ff})), 0.0);
}

class PaletteTest : public testing::TestWithParam<Theme> {
protected:
    const Palette& palette_ = paletteOf(GetParam());
};

TEST_P(PaletteTest, TextIsReadableOnEveryGround) {
    for (const QColor& ground : {palette_.panel, palette_.window, palette_.raised, palette_.field}) {
        EXPECT_GE(contrast(palette_.text, ground), 4.5) << ground.name().toStdString();
        EXPECT_GE(contrast(palette_.dim, ground), GetParam() == Theme::Night ? 4.3 : 4.5)
            << ground.name().toStdString();
    }
    for (const QColor& colour : {palette_.dim, palette_.accent, palette_.warning, palette_.alarm, palette_.staged})
        EXPECT_GE(contrast(colour, palette_.panel), 4.45) << colour.name().toStdString();
    EXPECT_GE(contrast(palette_.text, palette_.selected), 4.5);
}

TEST_P(PaletteTest, WhatIsInverseIsReadableToo) {
    const double least = GetParam() == Theme::Night ? 4.0 : 4.5;
    EXPECT_GE(contrast(palette_.panel, palette_.alarm), least) << "an alarm's box";
    EXPECT_GE(contrast(palette_.panel, palette_.warning), least) << "the word REPLAY";
}

TEST_P(PaletteTest, TermsAndStripsAreTellableOnTheirGround) {
    for (const QColor& colour : {palette_.accent, palette_.warning, palette_.text})
        for (const QColor& ground : {palette_.field, palette_.panel})
            EXPECT_GE(contrast(colour, ground), 3.0) << colour.name().toStdString();
}

TEST_P(PaletteTest, MarksAreTellableFromTheirGround) {
    EXPECT_GE(contrast(palette_.ok, palette_.panel), 3.0);
    EXPECT_GE(contrast(palette_.off, palette_.panel), 2.5);
    for (const QColor& overlay : {palette_.track, palette_.mark, palette_.region, palette_.danger, palette_.guard})
        EXPECT_GE(contrast(overlay, palette_.canvas), 3.0) << overlay.name().toStdString();
}

TEST_P(PaletteTest, NoOverlayLooksLikeAnEchoOfTheGreyMap) {
    const bool night = GetParam() == Theme::Night;
    const auto nearest = [&](const QColor& overlay) {
        double least = 100.0;
        for (const QRgb level : echoColours(EchoMap::Grey, GetParam()))
            least = std::min(least, colourDifference(overlay, QColor(level)));
        return least;
    };
    EXPECT_GE(nearest(palette_.track), night ? 25.0 : 19.0);
    EXPECT_GE(nearest(palette_.mark), night ? 17.0 : 16.0);
    EXPECT_GE(nearest(palette_.region), night ? 16.0 : 22.0);
    EXPECT_GE(nearest(palette_.danger), night ? 15.0 : 18.0);
    EXPECT_GE(nearest(palette_.guard), 15.0);
    EXPECT_GE(nearest(palette_.caution), 15.0);
}

TEST_P(PaletteTest, EveryEchoMapGetsLighterWithTheLevel) {
    for (const EchoMap map : echo_maps) {
        const EchoColours& colours = echoColours(map, GetParam());
        for (std::size_t level = 1; level < colours.size(); ++level)
            EXPECT_GE(test::lab(QColor(colours[level])).l, test::lab(QColor(colours[level - 1])).l - 0.45)
                << echoMapTitle(map).toStdString() << " " << level;
        EXPECT_GT(test::lab(QColor(colours[255])).l, test::lab(QColor(colours[0])).l + 30.0);
    }
}

TEST_P(PaletteTest, NoEchoIsBrighterThanTheMarks) {
    for (const EchoMap map : echo_maps)
        EXPECT_LE(test::luminance(QColor(echoColours(map, GetParam())[255])), test::luminance(palette_.mark));
}

INSTANTIATE_TEST_SUITE_P(Themes, PaletteTest, testing::ValuesIn(all_themes),
                         [](const auto& test) { return themeName(test.param).toStdString(); });

TEST(EchoMaps, EndWhereTheyShould) {
    const auto ends = [](EchoMap map, Theme theme) {
        const EchoColours& colours = echoColours(map, theme);
        return std::pair(colours.front(), colours.back());
    };
    EXPECT_EQ(ends(EchoMap::Grey, Theme::Dusk), std::pair(0xff06080aU, 0xffb8b8b8U));
    EXPECT_EQ(ends(EchoMap::Grey, Theme::Night), std::pair(0xff020203U, 0xff726a64U));
    EXPECT_EQ(ends(EchoMap::Bronze, Theme::Day), std::pair(0xff000000U, 0xffe2bd7cU));
    EXPECT_EQ(ends(EchoMap::Viridis, Theme::Day), std::pair(0xff440154U, 0xfffde725U));
    EXPECT_EQ(echoColours(EchoMap::Grey, Theme::Day), echoColours(EchoMap::Grey, Theme::Dusk));
}

TEST(Themes, NamesGoThereAndBack) {
    for (const Theme theme : all_themes) EXPECT_EQ(themeFromName(themeName(theme)), theme);
    EXPECT_EQ(themeFromName("noon"), Theme::Dusk);
}

}  // namespace
}  // namespace echotrail
