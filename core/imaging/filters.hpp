#pragma once

#include "core/base/parameters.hpp"

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

}  // namespace echotrail
