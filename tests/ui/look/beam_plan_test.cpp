#include "core/data/beam_line.hpp"
#include "pictures.hpp"
#include "sample_scene.hpp"
#include "ui/panels/beam/beam_panel.hpp"
#include "ui/panels/plan/plan_view.hpp"
#include "ui/style/palette.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>

namespace echotrail {
namespace {

using test::pictureOf;
using test::pixelsLike;

/// Of a line that may lie between two rows of pixels.
int yellowPixels(const QImage& picture) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            if (qRed(pixel) - qBlue(pixel) > 60 && qGreen(pixel) - qBlue(pixel) > 60) ++count;
        }
    return count;
}

/// 100 cells of 0.2 m: 20 dB everywhere, an echo of `peak_db` at 12 m.
std::shared_ptr<const BeamLine> line(double degrees, double age_s, double peak_db) {
    BeamLine beam{.time = test::scene_time - microsecondsFromSeconds(age_s),
                  .from_bow = Bearing::degrees(degrees),
                  .from_north = Bearing::degrees(degrees),
                  .cell_m = 0.2};
    beam.level.assign(100, static_cast<std::uint8_t>(20.0 * levels_per_db));
    beam.level[59] = static_cast<std::uint8_t>(peak_db * levels_per_db);
    beam.threshold.assign(100, static_cast<std::uint8_t>(std::lround(32.0 * levels_per_db)));
    std::fill_n(beam.threshold.begin(), 10, BeamLine::never);
    beam.level[1] = 250;  // the transducer rings
    return std::make_shared<const BeamLine>(beam);
}

Scene sceneWithLines() {
    Scene scene = test::bareScene();
    scene.lines = {line(-20.0, 2.0, 40.0), nullptr, line(9.5, 1.5, 50.0)};
    scene.live_line = line(45.0, 0.0, 30.0);
    return scene;
}

class BeamTest : public testing::Test {
protected:
    BeamTest() {
        applyTheme(*qApp, Theme::Dusk);
        beam_.resize(800, 160);
    }
    BeamPanel beam_;
};

TEST_F(BeamTest, TheBeamUnderTheCursorGoesBeforeTheTargetsAndThatBeforeTheLiveOne) {
    Scene scene = sceneWithLines();
    beam_.setScene(test::shared(scene));
    EXPECT_TRUE(beam_.reading().startsWith("045.0")) << "live";
    scene.tracks = {test::sampleTrack(1, TrackState::Confirmed, 12.0, 2.0)};
    scene.tracks[0].target = true;
    beam_.setScene(test::shared(scene));
    EXPECT_TRUE(beam_.reading().startsWith("009.5")) << beam_.reading().toStdString();
    beam_.setCursor(Eigen::Vector2d(10.0, -3.6));
    EXPECT_TRUE(beam_.reading().startsWith("340.0")) << beam_.reading().toStdString();
    EXPECT_TRUE(beam_.reading().contains("2.0 s old"));
    EXPECT_TRUE(beam_.reading().contains("40 dB at 11.9 m")) << beam_.reading().toStdString();
    EXPECT_TRUE(beam_.reading().contains("32 dB"));
    beam_.setCursor(Eigen::Vector2d(-10.0, 0.0));
    EXPECT_TRUE(beam_.reading().startsWith("045.0")) << "nothing was heard there";
}

TEST_F(BeamTest, TheThresholdIsDrawnWhereItIsKnownAndSaidWhereItIsNot) {
    Scene scene = sceneWithLines();
    beam_.setScene(test::shared(scene));
    EXPECT_GT(yellowPixels(pictureOf(beam_)), 100);
    BeamLine bare = *scene.live_line;
    bare.threshold.clear();
    scene.live_line = std::make_shared<const BeamLine>(bare);
    beam_.setScene(test::shared(scene));
    EXPECT_EQ(yellowPixels(pictureOf(beam_)), 0);
    EXPECT_TRUE(beam_.reading().contains("not told"));
}

TEST_F(BeamTest, NothingIsPaintedToo) {
    pictureOf(beam_);
    beam_.setScene(test::shared(Scene{}));
    pictureOf(beam_);
    EXPECT_EQ(beam_.reading(), "No beam yet");
}

Scene sceneWithPaths() {
    Scene scene = test::bareScene();
    scene.navigation_known = true;
    Paths paths;
    for (int i = 0; i < 5; ++i)
        paths.vehicle.push_back({test::scene_time + std::chrono::seconds(i), {1.0 * i, 0.0, Bearing::degrees(-10.0)}});
    paths.tracks[3] = {{test::scene_time, {8.0F, 4.25F}}};
    scene.paths = std::make_shared<const Paths>(paths);
    scene.latest.pose.north_m = 4.0;
    return scene;
}

TEST(PlanView, PathsAreExportedAsNumbersThatAnyProgramReads) {
    PlanView plan;
    EXPECT_EQ(plan.csv(), "who,utc,north_m,east_m,heading_deg\n");
    plan.setScene(test::shared(sceneWithPaths()));
    const QList<QByteArray> lines = plan.csv().trimmed().split('\n');
    ASSERT_EQ(lines.size(), 7);
    EXPECT_TRUE(lines[1].startsWith("vehicle,2010-05-23T08:00:00")) << lines[1].toStdString();
    EXPECT_TRUE(lines[5].endsWith(",4.000,0.000,350.00")) << lines[5].toStdString();
    EXPECT_TRUE(lines[6].startsWith("T03,")) << lines[6].toStdString();
    EXPECT_TRUE(lines[6].endsWith(",8.000,4.250,")) << lines[6].toStdString();
}

TEST(PlanView, IsPaintedInEveryPaletteWithAndWithoutPaths) {
    PlanView plan;
    plan.resize(320, 300);
    for (const Theme theme : {Theme::Day, Theme::Dusk, Theme::Night}) {
        applyTheme(*qApp, theme);
        plan.setScene(nullptr);
        const QImage empty = pictureOf(plan);
        plan.setScene(test::shared(sceneWithPaths()));
        EXPECT_GT(pixelsLike(pictureOf(plan), paletteOf(theme).mark), pixelsLike(empty, paletteOf(theme).mark));
    }
}

}  // namespace
}  // namespace echotrail
