#include "core/imaging/filters.hpp"

#include <opencv2/imgproc.hpp>

namespace echotrail {

void smoothGaussian(cv::Mat& levels, const GaussianParams& params) {
    if (levels.empty()) return;  // OpenCV would throw
    // OpenCV computes 8-bit pictures in fixed point: the same bytes on every machine.
    const int size = params.gaussian_size_pixels | 1;
    cv::GaussianBlur(levels, levels, cv::Size(size, size), params.gaussian_sigma_pixels, params.gaussian_sigma_pixels,
                     cv::BORDER_REPLICATE);
}

}  // namespace echotrail
