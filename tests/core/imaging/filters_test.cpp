#include "core/imaging/filters.hpp"

#include "tests/core/imaging/fan_fixture.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdint>

namespace echotrail {
namespace {

TEST(Gaussian, AnImpulseBecomesTheSampledGaussian) {
    cv::Mat levels(11, 11, CV_8U, cv::Scalar(0));
    levels.at<std::uint8_t>(5, 5) = 255;
    smoothGaussian(levels);
    double weight[3], total = 0;
    for (int i = -2; i <= 2; ++i) total += weight[std::abs(i)] = std::exp(-i * i / 2.0);
    for (int row = 0; row < 11; ++row)
        for (int column = 0; column < 11; ++column) {
            const int down = std::abs(row - 5), right = std::abs(column - 5);
            const double expected = down > 2 || right > 2 ? 0 : 255 * weight[down] * weight[right] / (total * total);
            EXPECT_NEAR(levels.at<std::uint8_t>(row, column), expected, 1.0) << row << ' ' << column;
        }
}

TEST(Gaussian, AConstantPictureStaysAsItIsUpToItsEdges) {
    for (const int level : {0, 1, 77, 254, 255}) {
        cv::Mat levels(9, 13, CV_8U, cv::Scalar(level));
        smoothGaussian(levels);
        EXPECT_EQ(cv::countNonZero(levels != level), 0) << level;
    }
}

TEST(Gaussian, TheDescribedParametersDecideItsWidth) {
    cv::Mat narrow(31, 31, CV_8U, cv::Scalar(0)), wide = narrow.clone(), none = narrow.clone();
    for (cv::Mat* levels : {&narrow, &wide, &none}) levels->at<std::uint8_t>(15, 15) = 255;
    smoothGaussian(narrow, {3, 0.5});
    smoothGaussian(wide, {8, 2.0});  // counts as 9
    smoothGaussian(none, {1, 1.0});
    EXPECT_EQ(cv::boundingRect(narrow), cv::Rect(14, 14, 3, 3));
    EXPECT_EQ(cv::boundingRect(wide).width, 9);
    EXPECT_EQ(none.at<std::uint8_t>(15, 15), 255);
}

TEST(Gaussian, AnEmptyPictureIsLeftAlone) {
    cv::Mat empty;
    smoothGaussian(empty);
    EXPECT_TRUE(empty.empty());
}

TEST(MedianBackground, ForgetsWhatIsSmallAndKeepsWhatIsWide) {
    FanImage fan = emptyTile(0, 0, 160, 200, 0.125);
    fan.beam_time_ms.setTo(0);
    fan.levels.setTo(40);
    fan.levels(cv::Rect(120, 0, 80, 160)).setTo(90);  // a bank
    fan.levels(cv::Rect(40, 60, 10, 10)).setTo(200);  // a target
    const cv::Mat background = medianBackground(fan);
    ASSERT_EQ(background.size(), fan.levels.size());
    EXPECT_EQ(background.at<std::uint8_t>(65, 45), 40);
    EXPECT_EQ(background.at<std::uint8_t>(80, 170), 90);
}

TEST(MedianBackground, UnscannedPixelsAreLikeTheRest) {
    FanImage fan = emptyTile(0, 0, 100, 100, 0.125);
    fan.beam_time_ms(cv::Rect(0, 0, 50, 100)).setTo(0);
    fan.levels(cv::Rect(0, 0, 50, 100)).setTo(60);
    EXPECT_EQ(cv::countNonZero(medianBackground(fan) != 60), 0);
    EXPECT_TRUE(medianBackground({}).empty());
}

}  // namespace
}  // namespace echotrail
