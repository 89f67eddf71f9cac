#include "evaluation_columns.hpp"

#include "core/pipelines/presets.hpp"
#include "settings.hpp"

#include <algorithm>
#include <filesystem>

namespace echotrail {

namespace {

constexpr std::string_view scene_mark = "{scene}";

/// What a name is made of; a file whose own name holds a + is itself.
std::vector<std::string> layersOf(const std::string& name) {
    if (std::filesystem::exists(name)) return {name};
    std::vector<std::string> layers;
    std::size_t begin = 0;
    for (std::size_t end = name.find('+'); end != std::string::npos; end = name.find('+', begin)) {
        layers.push_back(name.substr(begin, end - begin));
        begin = end + 1;
    }
    layers.push_back(name.substr(begin));
    return layers;
}

std::string inScene(std::string layer, const std::string& scene) {
    for (std::size_t at = layer.find(scene_mark); at != std::string::npos; at = layer.find(scene_mark, at))
        layer.replace(at, scene_mark.size(), scene);
    return layer;
}

std::string titleOf(const std::string& name) {
    std::string title;
    for (const std::string& layer : layersOf(name))
        title.append(title.empty() ? "" : "+").append(std::filesystem::path(layer).filename().string());
    return title;
}

Result<Settings> settingsOf(const std::string& name, const std::string& scene) {
    std::vector<std::string> layers = layersOf(name);
    if (layers.front() == default_column && !findPreset(default_column)) layers.erase(layers.begin());
    for (std::string& layer : layers) layer = inScene(layer, scene);
    return readSettings(layers, {});
}

}  // namespace

Result<std::vector<EvaluationPlan::Column>> columnsOf(std::vector<std::string> names,
                                                      const std::vector<std::string>& assignments,
                                                      const std::vector<EvaluationPlan::Scene>& scenes) {
    if (std::find(names.begin(), names.end(), default_column) == names.end())
        names.insert(names.begin(), std::string(default_column));
    std::vector<EvaluationPlan::Column> columns;
    for (const std::string& name : names) {
        const std::string title = titleOf(name);
        const auto same = std::count_if(names.begin(), names.end(),
                                        [&](const std::string& other) { return titleOf(other) == title; });
        EvaluationPlan::Column column{.title = same > 1 || title.empty() ? name : title};
        for (const EvaluationPlan::Scene& scene : scenes) {
            const auto settings = settingsOf(name, scene.name);
            if (!settings) return Error{settings.error()};
            column.params.push_back(settings->params);
            column.sound_speed = settings->sound_speed;
        }
        columns.push_back(std::move(column));
    }
    if (assignments.empty()) return columns;
    const auto settings = readSettings({}, assignments);
    if (!settings) return Error{settings.error()};
    EvaluationPlan::Column column;
    for (const std::string& assignment : assignments) column.title += (column.title.empty() ? "" : ", ") + assignment;
    column.params.assign(scenes.size(), settings->params);
    column.sound_speed = settings->sound_speed;
    columns.push_back(std::move(column));
    return columns;
}

std::vector<std::string> ablationColumns() {
    const auto with = [](const std::string& base, std::initializer_list<const char*> parts) {
        std::vector<std::string> names{base};
        for (const char* part : parts) names.push_back(base + "+ablations/" + part);
        return names;
    };
    std::vector<std::string> names =
        with("paper", {"area_only", "moment_only", "covariance_as_printed", "product", "reference_scaled", "soft",
                       "constant_velocity", "no_motion_correction", "whole_sweep",
                       "enhanced+enhancement/{scene}-published", "enhanced+enhancement/{scene}-guarded"});
    const auto ours = with("default", {"position_only",
                                       "area_only",
                                       "moment_only",
                                       "no_area_no_moment",
                                       "no_strength",
                                       "no_level",
                                       "sum",
                                       "no_floor",
                                       "reference_first_look",
                                       "no_learning",
                                       "one_track",
                                       "alone",
                                       "no_ghosts",
                                       "no_interest",
                                       "centroid_by_decibels",
                                       "published_process_noise",
                                       "random_walk",
                                       "covariance_as_printed",
                                       "no_motion_correction",
                                       "whole_sweep",
                                       "enhanced+enhancement/{scene}-published",
                                       "enhanced+enhancement/{scene}-guarded"});
    names.insert(names.end(), ours.begin(), ours.end());
    return names;
}

}  // namespace echotrail
