#pragma once

#include "core/base/parameters.hpp"

#include <QString>
#include <QStringList>
#include <vector>

namespace echotrail {

/// Sets of parameters with names: those of the program, and the operator's own, each a file of a folder.
class ParameterPresets {
public:
    struct BuiltIn {
        QString name;
        std::string toml;
    };
    static constexpr int longest_name = 40;  ///< characters

    ParameterPresets() = default;
    /// `folder` is made when the first one is saved.
    ParameterPresets(std::vector<BuiltIn> built_in, QString folder)
        : built_in_(std::move(built_in)), folder_(std::move(folder)) {}

    QStringList builtIn() const;
    QStringList own() const;
    /// What the preset sets, over `values` for what it does not mention.
    Result<std::vector<ParameterValue>> read(const QString& name, const std::vector<ParameterInfo>& infos,
                                             std::vector<ParameterValue> values) const;
    /// Keeps all values as one of the operator's own, in place of one with this name. The error says why it cannot.
    Result<void> save(const QString& name, const std::vector<ParameterInfo>& infos,
                      const std::vector<ParameterValue>& values) const;

private:
    QString pathOf(const QString& name) const { return folder_ + "/" + name + ".toml"; }

    std::vector<BuiltIn> built_in_;
    QString folder_;
};

}  // namespace echotrail
