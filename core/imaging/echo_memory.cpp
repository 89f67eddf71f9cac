#include "core/imaging/echo_memory.hpp"

#include "core/data/ping.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr int longest_mean = 8;  ///< sweeps; a longer mean would keep what has left for too long
constexpr int speckle_pixels = 3;

/// Where the picture's first pixel lies in the remembered one.
cv::Point offsetOf(const FanImage& fan, const RememberedEchoes& remembered) {
    return {static_cast<int>(std::lround((fan.east_m - remembered.east_m) / remembered.pixel_m)),
            static_cast<int>(std::lround((remembered.north_m - fan.north_m) / remembered.pixel_m))};
}

void copyCommon(const cv::Mat& from, cv::Mat& to, cv::Point offset) {
    const cv::Rect common = cv::Rect(offset, to.size()) & cv::Rect(cv::Point(), from.size());
    if (!common.empty()) from(common).copyTo(to(common - offset));
}

}  // namespace

std::shared_ptr<RememberedEchoes> EchoMemory::laidUnder(const FanImage& fan) const {
    auto next = std::make_shared<RememberedEchoes>();
    next->background = cv::Mat::zeros(fan.levels.size(), CV_8U);
    next->looks = cv::Mat::zeros(fan.levels.size(), CV_8U);
    next->trail_time_ms = cv::Mat(fan.levels.size(), CV_32S, cv::Scalar(FanImage::never_scanned));
    next->pixel_m = fan.pixel_m;
    next->north_m = fan.north_m;
    next->east_m = fan.east_m;
    if (!remembered_ || remembered_->pixel_m != fan.pixel_m) return next;
    const cv::Point offset = offsetOf(fan, *remembered_);
    copyCommon(remembered_->background, next->background, offset);
    copyCommon(remembered_->looks, next->looks, offset);
    copyCommon(remembered_->trail_time_ms, next->trail_time_ms, offset);
    return next;
}

void EchoMemory::add(const FanImage& fan) {
    if (fan.empty()) return;
    const auto next = laidUnder(fan);
    cv::Mat smooth;  // one bright pixel of speckle is no echo
    cv::blur(fan.levels, smooth, cv::Size(speckle_pixels, speckle_pixels));
    const int stands_out = static_cast<int>(std::lround(trail_excess_db * levels_per_db));
    std::int32_t newest = newest_ms_;
    for (int y = 0; y < fan.levels.rows; ++y) {
        const auto* level = smooth.ptr<std::uint8_t>(y);
        const auto* time = fan.beam_time_ms.ptr<std::int32_t>(y);
        auto* background = next->background.ptr<std::uint8_t>(y);
        auto* looks = next->looks.ptr<std::uint8_t>(y);
        auto* trail = next->trail_time_ms.ptr<std::int32_t>(y);
        for (int x = 0; x < fan.levels.cols; ++x) {
            if (time[x] <= newest_ms_) continue;  // not looked at since
            newest = std::max(newest, time[x]);
            const int excess = level[x] - background[x];
            if (looks[x] >= least_looks && excess >= stands_out) trail[x] = time[x];
            looks[x] = static_cast<std::uint8_t>(std::min(looks[x] + 1, 255));
            const int share = std::min<int>(looks[x], longest_mean);
            // Rounded away from zero, or the mean would stop short of the level.
            const int step = (std::abs(excess) + share / 2) / share;
            background[x] = static_cast<std::uint8_t>(background[x] + (excess < 0 ? -step : step));
        }
    }
    newest_ms_ = newest;
    remembered_ = next;
}

FanImage withoutBackground(const FanImage& fan, const RememberedEchoes& remembered) {
    FanImage result{cv::Mat(fan.levels.size(), CV_8U, cv::Scalar(0)),
                    cv::Mat(fan.levels.size(), CV_32S, cv::Scalar(FanImage::never_scanned)), fan.pixel_m, fan.north_m,
                    fan.east_m};
    if (fan.empty() || remembered.pixel_m != fan.pixel_m) return result;
    const cv::Point offset = offsetOf(fan, remembered);
    const cv::Rect there = cv::Rect(offset, fan.levels.size()) & cv::Rect(cv::Point(), remembered.background.size());
    if (there.empty()) return result;
    const cv::Rect here = there - offset;
    cv::subtract(fan.levels(here), remembered.background(there), result.levels(here));
    fan.beam_time_ms(here).copyTo(result.beam_time_ms(here), remembered.looks(there) >= EchoMemory::least_looks);
    return result;
}

}  // namespace echotrail
