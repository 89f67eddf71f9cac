#pragma once

#include <string_view>
#include <vector>

namespace echotrail {

/// A file of resources/presets, as the library holds it: a set of parameters with a name.
struct Preset {
    std::string_view name;  ///< the file's, without .toml
    std::string_view toml;
};
const std::vector<Preset>& presets();

/// Nothing where none has this name.
inline const Preset* findPreset(std::string_view name) {
    for (const Preset& preset : presets())
        if (preset.name == name) return &preset;
    return nullptr;
}

}  // namespace echotrail
