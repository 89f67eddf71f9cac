#pragma once

#include "core/base/parameters.hpp"

#include <QString>
#include <vector>

namespace echotrail {

/// The values `path` sets, over `values` for what it does not mention. The error says the line and what would be taken.
Result<std::vector<ParameterValue>> readParameterSet(const QString& path, const std::vector<ParameterInfo>& infos,
                                                     std::vector<ParameterValue> values);

/// The same of a text; `name` stands for the path in errors.
Result<std::vector<ParameterValue>> parameterSetFromText(std::string_view text, const QString& name,
                                                         const std::vector<ParameterInfo>& infos,
                                                         std::vector<ParameterValue> values);

/// Writes a set so that a crash half-way leaves the old file.
Result<void> writeParameterSet(const QString& path, const std::vector<ParameterInfo>& infos,
                               const std::vector<ParameterValue>& values);

}  // namespace echotrail
