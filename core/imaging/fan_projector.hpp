#pragma once

#include "core/base/parameters.hpp"
#include "core/data/fan_image.hpp"
#include "core/imaging/ray.hpp"

#include <cstdint>
#include <vector>

namespace echotrail {

struct FanProjectorParams {
    int pixels_per_range = 400;
};

template <>
struct Described<FanProjectorParams> {
    static constexpr std::string_view group = "Fan image";
    static constexpr auto fields =
        std::tuple{Field{&FanProjectorParams::pixels_per_range, "pixels_per_range", "pixels", 100, 800,
                         "Pixels from the head to the end of the range scale", Effect::NextSweep}};
};

/// Paints the fan ping by ping into a picture that stays fixed to the ground and follows the vehicle in whole
/// pixels. Each ping touches only its own wedge.
/// Order: rays in time order. State: the picture and the last ray.
class FanProjector {
public:
    using Params = FanProjectorParams;

    explicit FanProjector(const Params& params) : params_(params) {}
    void setParams(const Params& params) { params_ = params; }

    /// `broke_off`: the beam's movement broke off before this ray, so nothing is painted between it and the last.
    void add(const Ray& ray, double range_scale_m, bool broke_off);
    const FanImage& image() const { return image_; }

private:
    void follow(const Ray& ray, double range_scale_m);

    Params params_;
    FanImage image_;
    Ray last_;
    std::vector<std::uint8_t> last_levels_;
    bool has_last_ = false;
};

}  // namespace echotrail
