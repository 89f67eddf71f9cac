#include "core/recording/update_text.hpp"

#include <nlohmann/json.hpp>

namespace echotrail {

using nlohmann::ordered_json;

std::string lookText(const TrackLook& look) {
    const Eigen::Matrix2d& c = look.covariance_m2;
    ordered_json text{{"time", toIso8601(look.time)},
                      {"track", look.track},
                      {"state", toText(look.state)},
                      {"target", look.target},
                      {"seen", look.seen},
                      {"range_m", look.range_m},
                      {"bearing_rad", look.bearing.inRadians()},
                      {"position_m", {look.position_m.x(), look.position_m.y()}},
                      {"velocity_mps", {look.velocity_mps.x(), look.velocity_mps.y()}},
                      {"covariance_m2", {c(0, 0), c(0, 1), c(1, 1)}}};
    if (look.no_echo != NoEcho::None) text["cause"] = toText(look.no_echo);
    return text.dump();
}

std::string regionText(const Region& region) {
    return ordered_json{{"time", toIso8601(region.time)},
                        {"id", region.id},
                        {"range_m", region.range_m},
                        {"bearing_rad", region.bearing.inRadians()},
                        {"position_m", {region.position_m.x(), region.position_m.y()}},
                        {"area_m2", region.features.area_m2},
                        {"moment", region.features.moment},
                        {"strength_db", region.features.strength_db},
                        {"pixels", region.pixels},
                        {"clutter_mass", region.clutter_mass},
                        {"multipath", region.multipath}}
        .dump();
}

std::optional<LookState> lookStateFrom(std::string_view text) {
    const auto look = nlohmann::json::parse(text, nullptr, false);
    if (!look.is_object()) return std::nullopt;
    const auto track = look.find("track"), state = look.find("state");
    if (track == look.end() || !track->is_number_integer() || state == look.end() || !state->is_string())
        return std::nullopt;
    for (const TrackState each : {TrackState::Tentative, TrackState::Confirmed, TrackState::Coasting, TrackState::Lost})
        if (state->get_ref<const std::string&>() == toText(each)) return LookState{track->get<int>(), each};
    return std::nullopt;
}

}  // namespace echotrail
