#include "core/detection/region_grower.hpp"

#include "core/base/random.hpp"
#include "core/data/ping.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace echotrail {
namespace {

constexpr double pixel_m = 0.125;
const int seed_excess = static_cast<int>(std::lround(12 * levels_per_db));

struct Blob {
    double row, column, sigma_row, sigma_column, peak_db;
};

/// Background 20 dB and Gaussian (in dB: parabolic) blobs on it.
FanImage pictureOf(const std::vector<Blob>& blobs, int rows = 160, int columns = 200) {
    FanImage picture{cv::Mat(rows, columns, CV_8U), cv::Mat(rows, columns, CV_32S, cv::Scalar(0)), pixel_m, 0, 0};
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            double db = 20;
            for (const Blob& blob : blobs) {
                const double u = (r - blob.row) / blob.sigma_row, v = (c - blob.column) / blob.sigma_column;
                db = std::max(db, blob.peak_db - 4.34 * (u * u + v * v) / 2);
            }
            picture.levels.at<std::uint8_t>(r, c) = static_cast<std::uint8_t>(std::lround(db * levels_per_db));
        }
    return picture;
}

cv::Mat flatBackground(const FanImage& picture) {
    return cv::Mat(picture.levels.size(), CV_8U, cv::Scalar(std::round(20 * levels_per_db)));
}

std::vector<RegionPixels> growIn(const FanImage& picture) {
    return RegionGrower({})(picture, flatBackground(picture), seed_excess);
}

TEST(RegionGrower, FindsEachBlobWithItsPlaceAndArea) {
    const std::vector<Blob> blobs{{40, 50, 2, 4, 45}, {100, 150, 3, 3, 55}, {120, 60, 4, 2, 40}};
    const auto regions = growIn(pictureOf(blobs));
    ASSERT_EQ(regions.size(), 3u);
    EXPECT_NEAR(regions[0].peak.row, 100, 1);  // strongest first
    for (const Blob& blob : blobs) {
        bool found = false;
        for (const RegionPixels& region : regions) {
            double row = 0, column = 0;
            for (const RegionPixel& p : region.pixels) row += p.row, column += p.column;
            row /= static_cast<double>(region.pixels.size());
            column /= static_cast<double>(region.pixels.size());
            if (std::hypot(row - blob.row, column - blob.column) > 0.5) continue;
            found = true;
            // the contour 12 dB below the peak: 4.34 k²/2 = 12 → k = 2.35 deviations
            const double area = M_PI * 2.35 * 2.35 * blob.sigma_row * blob.sigma_column;
            EXPECT_NEAR(static_cast<double>(region.pixels.size()), area, 0.25 * area);
        }
        EXPECT_TRUE(found) << blob.row << "," << blob.column;
    }
}

TEST(RegionGrower, OriginOfThePictureDoesNotMatter) {
    const std::vector<Blob> blobs{{40, 50, 2, 4, 45}, {46, 58, 3, 3, 50}, {70, 60, 4, 2, 40}};
    std::vector<Blob> moved = blobs;
    for (Blob& blob : moved) blob.row += 37, blob.column += 23;
    const auto a = growIn(pictureOf(blobs)), b = growIn(pictureOf(moved));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].pixels.size(), b[i].pixels.size());
        for (std::size_t k = 0; k < a[i].pixels.size(); ++k) {
            EXPECT_EQ(a[i].pixels[k].row + 37, b[i].pixels[k].row);
            EXPECT_EQ(a[i].pixels[k].column + 23, b[i].pixels[k].column);
        }
    }
}

TEST(RegionGrower, GrowsNoFurtherThanTheEdge) {
    // A plateau 15 dB over the background, with a much brighter square in it: its steep flank is the boundary.
    FanImage picture = pictureOf({}, 80, 80);
    const auto level = [](double db) { return cv::Scalar(std::round(db * levels_per_db)); };
    cv::rectangle(picture.levels, {20, 20, 40, 40}, level(29), cv::FILLED);
    cv::rectangle(picture.levels, {35, 35, 6, 6}, level(40), cv::FILLED);
    const auto regions = growIn(picture);
    ASSERT_FALSE(regions.empty());
    EXPECT_LE(regions[0].pixels.size(), 8u * 8u);
    EXPECT_GE(regions[0].pixels.size(), 6u * 6u);
}

TEST(RegionGrower, DetachedPatchesOfOneTargetMerge) {
    const auto together = growIn(pictureOf({{40, 50, 2, 2, 45}, {40, 56, 2, 2, 43}}));
    EXPECT_EQ(together.size(), 1u);
    const auto apart = growIn(pictureOf({{40, 50, 2, 2, 45}, {40, 80, 2, 2, 43}}));
    EXPECT_EQ(apart.size(), 2u);
}

TEST(RegionGrower, LargeAreaIsAClutterMassAndAPeakInsideItIsFoundAgain) {
    FanImage picture = pictureOf({}, 200, 200);
    cv::rectangle(picture.levels, {20, 20, 150, 120}, cv::Scalar(std::round(36 * levels_per_db)), cv::FILLED);
    const FanImage peak = pictureOf({{80, 90, 2, 2, 52}}, 200, 200);
    cv::max(picture.levels, peak.levels, picture.levels);
    int masses = 0, targets = 0;
    for (const RegionPixels& region : growIn(picture)) {
        masses += region.clutter_mass;
        targets +=
            !region.clutter_mass && std::abs(region.peak.row - 80) <= 1 && std::abs(region.peak.column - 90) <= 1;
    }
    EXPECT_GE(masses, 1);
    EXPECT_GE(targets, 1);
}

TEST(RegionGrower, NoiseAloneGivesFewRegions) {
    // One look per pixel of speckle, 5.6 dB deviation, smoothed as the pipeline does.
    int regions = 0;
    for (int trial = 0; trial < 10; ++trial) {
        RandomStream random(5, trial, 0);
        cv::Mat noise(200, 200, CV_32F);
        for (int r = 0; r < 200; ++r)
            for (int c = 0; c < 200; ++c)
                noise.at<float>(r, c) = static_cast<float>(
                    std::clamp((30 + 10 * std::log10(-std::log(random.uniform()))) * levels_per_db, 0.0, 255.0));
        FanImage picture{cv::Mat(), cv::Mat(200, 200, CV_32S, cv::Scalar(0)), pixel_m, 0, 0};
        noise.convertTo(picture.levels, CV_8U);
        cv::GaussianBlur(picture.levels, picture.levels, {5, 5}, 1.0);
        const cv::Mat background(200, 200, CV_8U, cv::Scalar(std::round(28.4 * levels_per_db)));
        regions += static_cast<int>(RegionGrower({})(picture, background, seed_excess).size());
    }
    EXPECT_LE(regions, 30);
}

TEST(RegionGrower, EmptyAndTinyPicturesAreFine) {
    EXPECT_TRUE(growIn(pictureOf({}, 1, 1)).empty());
    EXPECT_TRUE(growIn(pictureOf({}, 50, 50)).empty());
}

}  // namespace
}  // namespace echotrail
