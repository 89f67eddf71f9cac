#include "settings.hpp"

#include "core/pipelines/presets.hpp"

#include <algorithm>
#include <sstream>

namespace echotrail {

namespace {

std::string limitsOf(const ParameterInfo& info) {
    std::ostringstream text;
    if (!info.choices.empty()) {
        for (std::size_t i = 0; i < info.choices.size(); ++i) text << (i ? " | " : "") << info.choices[i];
    } else if (std::holds_alternative<bool>(info.default_value)) {
        text << "false | true";
    } else {
        text << info.minimum << " to " << info.maximum;
    }
    return text.str();
}

/// What a file, or the preset of this name, says.
Result<std::vector<ParameterAssignment>> readFileOrPreset(const std::string& name) {
    if (const Preset* preset = findPreset(name)) return readParameterText(preset->toml, name);
    return readParameterFile(name);
}

}  // namespace

Result<Settings> readSettings(const std::vector<std::string>& files, const std::vector<std::string>& assignments,
                              const ScanningSonarPipeline::Params& base) {
    Settings settings{.params = base};
    bool sets_sound_speed = false;
    for (const std::string& file : files) {
        const auto said = readFileOrPreset(file);
        if (!said) return Error{said.error()};
        for (const ParameterAssignment& assignment : *said) {
            if (const auto set = setParameter(settings.params, assignment.name, assignment.value); !set)
                return Error{file + ":" + std::to_string(assignment.line) + ": " + set.error()};
            sets_sound_speed |= assignment.name == "sound_speed";
        }
    }
    for (const std::string& assignment : assignments) {
        if (const auto set = setParameterFromText(settings.params, assignment); !set) return Error{set.error()};
        sets_sound_speed |= assignment.starts_with("sound_speed=");
    }
    if (sets_sound_speed) settings.sound_speed = settings.params.head.sound_speed;
    return settings;
}

std::string parameterHelp() {
    return parameterHelp("Parameters, for --set NAME=VALUE and for TOML files (--parameters)",
                         describeParameters<ScanningSonarPipeline::Params>());
}

std::string parameterHelp(const std::string& title, const std::vector<ParameterInfo>& infos) {
    std::ostringstream text;
    text << title << ": name, default, unit, limits\n";
    std::string group;
    for (const ParameterInfo& info : infos) {
        if (info.group != group) text << "\n" << (group = info.group) << "\n";
        text << "  " << info.name << " = " << ParameterInfo::toText(info.default_value)
             << (info.unit.empty() ? "" : " " + info.unit) << "  (" << limitsOf(info) << ")\n      " << info.help
             << "\n";
    }
    return text.str();
}

}  // namespace echotrail
