#include "core/pipelines/presets.hpp"

#include "core/pipelines/scanning_sonar_pipeline.hpp"

#include <gtest/gtest.h>

#include <string>

namespace echotrail {
namespace {

TEST(Presets, EachAndEveryPartSetsParametersThereAre) {
    for (const auto* all : {&presets(), &presetParts()}) {
        EXPECT_FALSE(all->empty());
        for (const Preset& preset : *all) {
            const std::string name(preset.name);
            const auto said = readParameterText(preset.toml, name);
            ASSERT_TRUE(said) << said.error();
            EXPECT_FALSE(said->empty()) << name;
            ScanningSonarPipeline::Params params;
            for (const ParameterAssignment& assignment : *said) {
                const auto set = setParameter(params, assignment.name, assignment.value);
                EXPECT_TRUE(set) << name << ": " << (set ? "" : set.error());
            }
        }
    }
}

TEST(Presets, EverySceneOfThePublishedTrialsHasBothItsEnhancements) {
    for (const char* scene : {"S1", "S2", "S3", "S4", "S5"})
        for (const char* objective : {"published", "guarded"})
            EXPECT_NE(findPreset(std::string("enhancement/") + scene + "-" + objective), nullptr) << scene;
}

}  // namespace
}  // namespace echotrail
