#include "core/tuning/enhancement_tuning.hpp"

#include "core/simulation/simulated_source.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

const std::vector<FanImage>& pictures() {
    static const std::vector<FanImage> two = [] {
        Scenario scenario = *findScenario("S2");
        scenario.duration_s = 40;
        SimulatedSource source(scenario, 1);
        return sweepPictures(source, 2);
    }();
    return two;
}

TEST(EnhancementTuning, PicturesAreWholeSweepsCutToWhatWasScanned) {
    ASSERT_EQ(pictures().size(), 2U);
    for (const FanImage& picture : pictures()) {
        const cv::Mat scanned = picture.beam_time_ms != FanImage::never_scanned;
        double first = 0, last = 0;
        cv::minMaxLoc(picture.beam_time_ms, nullptr, &last);
        cv::minMaxLoc(picture.beam_time_ms, &first, nullptr, nullptr, nullptr, scanned);
        EXPECT_NEAR(last - first, 5000, 600);  // 50 pings of 0.1 s
        for (const cv::Mat& side :
             {scanned.row(0), scanned.row(scanned.rows - 1), scanned.col(0), scanned.col(scanned.cols - 1)})
            EXPECT_GT(cv::countNonZero(side), 0);
    }
    EXPECT_GT(pictures()[1].beam_time_ms.at<std::int32_t>(pictures()[1].levels.rows / 2, pictures()[1].levels.cols / 2),
              20'000);
}

TEST(EnhancementTuning, MakesTheObjectiveGreaterThanTheStartDoes) {
    const std::vector<FanImage> one{pictures().front()};
    for (const auto objective : {EnhancementObjective::Published, EnhancementObjective::Guarded}) {
        const TunedEnhancement tuned = tuneEnhancement(one, objective, 1);
        EXPECT_EQ(tuned.evaluations, 600);
        EXPECT_GT(tuned.value, 0.0);
        EXPECT_GE(tuned.params.enhance_b, objective == EnhancementObjective::Guarded ? 0.05 : 0.01);
        if (objective == EnhancementObjective::Published) {
            EXPECT_GT(tuned.value, 2 * tuned.plain_value);
        }
        int asked = 0;
        const auto start = tuneEnhancement(one, objective, 1, {}, [&] { return ++asked > 1; });
        EXPECT_EQ(start.evaluations, 20);
        EXPECT_GE(tuned.value, start.value);
    }
}

TEST(EnhancementTuning, WithoutPicturesThereIsNothingToTune) {
    EXPECT_EQ(tuneEnhancement({}, EnhancementObjective::Published, 1).evaluations, 0);
}

}  // namespace
}  // namespace echotrail
