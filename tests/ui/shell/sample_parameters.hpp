#pragma once

#include "core/base/parameters.hpp"

namespace echotrail::test {

enum class Mode { Plain, Careful };

struct SampleSettings {
    double threshold_db = 12.0;
    int looks = 3;
    bool enabled = true;
    Mode mode = Mode::Plain;
};

struct OtherSettings {
    double gate_m = 2.5;
};

}  // namespace echotrail::test

namespace echotrail {

template <>
struct Described<test::SampleSettings> {
    static constexpr std::string_view group = "Detection";
    static constexpr auto fields = std::tuple{
        Field{&test::SampleSettings::threshold_db, "threshold_db", "dB", 3, 40, "Excess over the background"},
        Field{&test::SampleSettings::looks, "looks", "", 1, 10, "Looks until a track is confirmed"},
        flag(&test::SampleSettings::enabled, "enabled", "Whether anything is detected"),
        ChoiceField<test::SampleSettings, test::Mode, 2>{
            &test::SampleSettings::mode, "mode", {"plain", "careful"}, "How hard it looks"}};
};

template <>
struct Described<test::OtherSettings> {
    static constexpr std::string_view group = "Tracking";
    static constexpr auto fields =
        std::tuple{Field{&test::OtherSettings::gate_m, "gate_m", "m", 0, 50, "Where the next echo is expected"}};
};

namespace test {

inline std::vector<ParameterInfo> sampleParameters() {
    auto infos = describeParameters<SampleSettings>();
    for (const ParameterInfo& info : describeParameters<OtherSettings>()) infos.push_back(info);
    return infos;
}

}  // namespace test
}  // namespace echotrail
