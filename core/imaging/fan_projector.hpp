#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/imaging/ray.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

struct FanProjectorParams {
    int fan_pixels_per_range = 400;
    double fan_margin_m = 10.0;
};

template <>
struct Described<FanProjectorParams> {
    static constexpr std::string_view group = "Fan image";
    static constexpr auto fields =
        std::tuple{Field{&FanProjectorParams::fan_pixels_per_range, "fan_pixels_per_range", "pixels", 50, 1000,
                         "Pixels from the head to the end of the range scale"},
                   Field{&FanProjectorParams::fan_margin_m, "fan_margin_m", "m", 0.5, 50,
                         "How far the picture reaches beyond the range scale (at most half of it), so that it need not "
                         "follow every small movement"}};
};

/// Paints the fan ping by ping into a picture that is fixed to the ground and follows the head in whole pixels
/// (method card, section b). A ping touches only the wedge between itself and the ping before it. What is still inside
/// the picture stays when it follows, and at another range scale, too (at the new pixel size).
/// Order: rays in time order. State: the picture, the last ray and a copy of its levels.
class FanProjector {
public:
    using Params = FanProjectorParams;

    explicit FanProjector(const Params& params) : params_(params) {}
    void setParams(const Params& params) { params_ = params; }

    /// `broke_off`: the beam's movement broke off before this ray (it turned round, pings are missing, or nobody knows
    /// where the vehicle was), so nothing is painted between it and the last.
    void add(const Ray& ray, double range_scale_m, bool broke_off);
    /// Its pixels change with the next add(). Empty before the first one.
    const FanImage& image() const { return image_; }
    /// Forgets the picture and the last ray.
    void reset();

private:
    bool follow(const Ray& ray, double range_scale_m);

    Params params_;
    FanImage image_;
    Ray last_;
    std::vector<std::uint8_t> last_levels_;
    bool has_last_ = false;
};

}  // namespace echotrail
