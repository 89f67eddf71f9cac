#pragma once

#include "core/base/result.hpp"
#include "evaluation_run.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace echotrail {

inline constexpr std::string_view default_column = "default";

/// The columns that `names` ask for, with the default before them unless it is among them. A name is a preset, a part
/// of one or a file, or several of them joined by +, the later over the earlier; {scene} in it stands for the name of
/// each scene. A column's title is its name without folders. Where there are assignments (NAME=VALUE), the default with
/// them is the last column. The error is a matter of usage.
Result<std::vector<EvaluationPlan::Column>> columnsOf(std::vector<std::string> names,
                                                      const std::vector<std::string>& assignments,
                                                      const std::vector<EvaluationPlan::Scene>& scenes);

/// The names of the columns that show what each part of the published method and of ours is worth (method card,
/// section h).
std::vector<std::string> ablationColumns();

}  // namespace echotrail
