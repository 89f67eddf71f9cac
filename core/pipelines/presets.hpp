#pragma once

#include <string_view>
#include <vector>

namespace echotrail {

/// A file of resources/presets, as the library holds it: a set of parameters with a name.
struct Preset {
    std::string_view name;  ///< the file's, without .toml; of a part with its folder: "ablations/area_only"
    std::string_view toml;
};
const std::vector<Preset>& presets();
/// What is put over a preset or the default, to see what that does: parts of the method left out or put back
/// ("ablations/…"), and local enhancements tuned to a scene ("enhancement/…").
const std::vector<Preset>& presetParts();

/// Of both. Nothing where none has this name.
inline const Preset* findPreset(std::string_view name) {
    for (const auto* all : {&presets(), &presetParts()})
        for (const Preset& preset : *all)
            if (preset.name == name) return &preset;
    return nullptr;
}

}  // namespace echotrail
