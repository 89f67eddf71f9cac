#include "core/imaging/filters.hpp"

#include <opencv2/imgproc.hpp>

namespace echotrail {

void smoothGaussian(cv::Mat& levels) {
    cv::GaussianBlur(levels, levels, cv::Size(5, 5), 1.0, 1.0, cv::BORDER_REPLICATE);
}

}  // namespace echotrail
