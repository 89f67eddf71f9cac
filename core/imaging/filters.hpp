#pragma once

#include <opencv2/core.hpp>

namespace echotrail {

/// Gaussian smoothing of 8-bit levels in place: 5×5, deviation 1 pixel; the picture's edge repeats.
void smoothGaussian(cv::Mat& levels);

}  // namespace echotrail
