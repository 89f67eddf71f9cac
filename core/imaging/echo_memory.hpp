#pragma once

#include "core/data/fan_image.hpp"

#include <cstdint>
#include <memory>

namespace echotrail {

/// What earlier sweeps have shown, pixel by pixel, for the eye only.
struct RememberedEchoes {
    cv::Mat background;     ///< 8-bit: mean level over the sweeps
    cv::Mat looks;          ///< 8-bit: sweeps that saw the pixel, up to 255
    cv::Mat trail_time_ms;  ///< 32-bit signed: when something last stood out there; FanImage::never_scanned
    double pixel_m = 0.0;
    double north_m = 0.0;  ///< of the centre of pixel (row 0, column 0)
    double east_m = 0.0;
};

/// Remembers the fan from sweep to sweep, fixed to the ground: the level each place usually has, and when something
/// stood out from it. What lies still becomes background within some sweeps; what moves leaves a trail.
/// Order: the picture at the end of each sweep. At another pixel size it begins anew.
class EchoMemory {
public:
    /// Sweeps that a background needs before anything can stand out from it.
    static constexpr int least_looks = 2;
    /// How far an echo stands out to leave a trail.
    static constexpr double trail_excess_db = 12.0;

    void add(const FanImage& fan);
    /// As it stands after the last add(); never changed afterwards. Null before the first.
    const std::shared_ptr<const RememberedEchoes>& remembered() const { return remembered_; }

private:
    std::shared_ptr<RememberedEchoes> laidUnder(const FanImage& fan) const;

    std::shared_ptr<const RememberedEchoes> remembered_;
    std::int32_t newest_ms_ = FanImage::never_scanned;  ///< of the last picture: what is older was counted then
};

/// The fan without what usually is there: how far each pixel exceeds its background, in levels; never_scanned where
/// the background is not known yet.
FanImage withoutBackground(const FanImage& fan, const RememberedEchoes& remembered);

}  // namespace echotrail
