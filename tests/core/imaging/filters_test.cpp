#include "core/imaging/filters.hpp"

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

}  // namespace
}  // namespace echotrail
