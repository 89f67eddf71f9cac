#include "ui/views/sector_edit.hpp"

#include "sample_scene.hpp"
#include "ui/views/fan_view.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

namespace echotrail {
namespace {

TEST(SectorEdit, AnEdgeMovesByWholeStepsAndTheOtherStays) {
    const CommandedSector start{0.0, 90.0, 1.8};
    const CommandedSector right = withWidth(start, SectorEdge::Right, 105.0);
    EXPECT_EQ(right, (CommandedSector{7.2, 104.4, 1.8})) << "58 steps of 1.8 degrees";
    EXPECT_NEAR(right.edge(SectorEdge::Left).inDegrees(), -45.0, 1e-6);
    EXPECT_NEAR(right.edge(SectorEdge::Right).inDegrees(), 59.4, 1e-6);
    EXPECT_EQ(widened(start, SectorEdge::Left, -10), (CommandedSector{9.0, 72.0, 1.8}));
}

TEST(SectorEdit, NoNarrowerThanAStepAndNoWiderThanRoundAndRound) {
    const CommandedSector start{170.0, 20.0, 0.9};
    EXPECT_EQ(withWidth(start, SectorEdge::Right, -50.0).width_deg, 0.9);
    EXPECT_EQ(withWidth(start, SectorEdge::Right, 359.8).width_deg, 360.0);
    EXPECT_EQ(withWidth(start, SectorEdge::Right, 5000.0).width_deg, 360.0);
    EXPECT_EQ(withWidth({0.0, 10.0, 0.05625}, SectorEdge::Left, 0.0).width_deg, 0.225) << "what a head can do";
    const CommandedSector astern = withWidth(start, SectorEdge::Right, 60.0);
    EXPECT_LT(astern.centre_deg, 0.0) << "round past astern";
    EXPECT_NEAR(astern.edge(SectorEdge::Left).inDegrees(), 160.0, 0.5);
}

TEST(SectorEdit, OutOfAFullCircleTheEdgesPartAstern) {
    const CommandedSector round{0.0, 360.0, 1.8};
    EXPECT_LT(round.edge(SectorEdge::Left).inDegrees(), -179.9);
    EXPECT_GT(round.edge(SectorEdge::Right).inDegrees(), 179.9);
    EXPECT_EQ(widened(round, SectorEdge::Right, -1), (CommandedSector{-0.9, 358.2, 1.8}));
}

/// A fan with handles at ±15° of a sector of 30°.
class SectorHandlesTest : public testing::Test {
protected:
    SectorHandlesTest() {
        applyTheme(*qApp, Theme::Dusk);
        view_.resize(1000, 900);
        view_.show();
        scene_ = test::shared(test::bareScene());
        view_.setScene(scene_);
        view_.setSector(CommandedSector{0.0, 30.0, 1.5}, true);
        QObject::connect(&view_, &FanView::sectorChosen, [this](const CommandedSector& sector) { chosen_ << sector; });
        QObject::connect(&view_, &FanView::designated, [this] { ++designations_; });
    }
    /// Near the outer ring, where a handle lies.
    QPoint at(double bearing_deg) const {
        const FanGeometry view = fitted(scene_->latest.pose, scene_->latest.pose.heading, sectorToFit(*scene_),
                                        view_.rect(), QMarginsF(44, 58, 44, 22));
        const double range_m = sectorToFit(*scene_).range_m - 30.0 / view.px_per_m;
        return view.at(range_m, Bearing::degrees(bearing_deg)).toPoint();
    }
    void drag(double from_deg, double to_deg) {
        QTest::mousePress(&view_, Qt::LeftButton, {}, at(from_deg));
        QTest::mouseMove(&view_, at((from_deg + to_deg) / 2.0));
        QTest::mouseMove(&view_, at(to_deg));
    }
    void letGo(double at_deg) { QTest::mouseRelease(&view_, Qt::LeftButton, {}, at(at_deg)); }
    void press(int key, Qt::KeyboardModifiers with = {}) { QTest::keyClick(&view_, static_cast<Qt::Key>(key), with); }

    FanView view_;
    std::shared_ptr<const Scene> scene_;
    QList<CommandedSector> chosen_;
    int designations_ = 0;
};

TEST_F(SectorHandlesTest, ADraggedEdgeIsCommandedWhenItIsLetGo) {
    drag(15.0, 27.0);
    EXPECT_TRUE(chosen_.isEmpty()) << "nothing while the hand holds it";
    letGo(27.0);
    ASSERT_EQ(chosen_.size(), 1);
    EXPECT_EQ(chosen_[0], (CommandedSector{6.0, 42.0, 1.5}));
    drag(-15.0, -9.0);
    letGo(-9.0);
    ASSERT_EQ(chosen_.size(), 2);
    EXPECT_EQ(chosen_[1], (CommandedSector{9.0, 36.0, 1.5})) << "from what is commanded now";
    EXPECT_EQ(designations_, 0);
}

TEST_F(SectorHandlesTest, EscGivesUpAndAHandThatComesBackCommandsNothing) {
    drag(15.0, 27.0);
    press(Qt::Key_Escape);
    letGo(27.0);
    drag(15.0, 27.0);
    QTest::mouseMove(&view_, at(15.0));
    letGo(15.0);
    EXPECT_TRUE(chosen_.isEmpty());
    EXPECT_EQ(designations_, 0);
}

TEST_F(SectorHandlesTest, KeysDoTheSame) {
    press(Qt::Key_Right);
    view_.editSector();
    press(Qt::Key_Right);
    press(Qt::Key_Right, Qt::ShiftModifier);
    press(Qt::Key_Tab);
    press(Qt::Key_Left);
    EXPECT_TRUE(chosen_.isEmpty());
    press(Qt::Key_Return);
    ASSERT_EQ(chosen_.size(), 1);
    EXPECT_EQ(chosen_[0], (CommandedSector{7.5, 48.0, 1.5})) << "eleven steps to starboard, one to port";
    view_.editSector();
    press(Qt::Key_Left);
    press(Qt::Key_Escape);
    press(Qt::Key_Return);
    EXPECT_EQ(chosen_.size(), 1);
}

TEST_F(SectorHandlesTest, WithoutAHeadThereIsNothingToTakeHoldOf) {
    view_.setSector(std::nullopt, false);
    drag(15.0, 27.0);
    letGo(27.0);
    view_.editSector();
    press(Qt::Key_Right);
    press(Qt::Key_Return);
    EXPECT_TRUE(chosen_.isEmpty());
}

TEST_F(SectorHandlesTest, WhatIsNotConfirmedLooksDifferent) {
    const auto cautions = [this] {
        QImage picture(view_.size(), QImage::Format_RGB32);
        view_.render(&picture);
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixel(x, y) == currentPalette().caution.rgb() ? 1 : 0;
        return count;
    };
    const int before = cautions();
    view_.setSector(CommandedSector{0.0, 30.0, 1.5}, false);
    EXPECT_GT(cautions(), before + 100);
}

}  // namespace
}  // namespace echotrail
