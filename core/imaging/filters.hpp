#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"

#include <opencv2/core.hpp>

namespace echotrail {

struct GaussianParams {
    int gaussian_size_pixels = 5;
    double gaussian_sigma_pixels = 1.0;
};

template <>
struct Described<GaussianParams> {
    static constexpr std::string_view group = "Smoothing";
    static constexpr auto fields =
        std::tuple{Field{&GaussianParams::gaussian_size_pixels, "gaussian_size_pixels", "pixels", 1, 31,
                         "Width of the Gaussian window; an even number counts as the next odd one"},
                   Field{&GaussianParams::gaussian_sigma_pixels, "gaussian_sigma_pixels", "pixels", 0.1, 10,
                         "Standard deviation of the Gaussian"}};
};

/// Gaussian smoothing of 8-bit levels in place, that is, in decibels (method card, section c). The picture's edge
/// repeats outwards. Constant pictures stay as they are.
void smoothGaussian(cv::Mat& levels, const GaussianParams& params = {});

/// The median over a square of 44 pixels about each pixel, computed at a quarter of the size (method card, section d):
/// the background that regions of a whole picture stand out from. Unscanned pixels count as the median of the scanned
/// ones. Of an empty picture it is empty.
cv::Mat medianBackground(const FanImage& fan);

}  // namespace echotrail
