#include "ui/forms/parameter_presets.hpp"

#include "ui/forms/parameter_set.hpp"

#include <QDir>
#include <QRegularExpression>
#include <algorithm>

namespace echotrail {

QStringList ParameterPresets::builtIn() const {
    QStringList names;
    for (const BuiltIn& preset : built_in_) names << preset.name;
    return names;
}

QStringList ParameterPresets::own() const {
    QStringList names;
    if (folder_.isEmpty()) return names;
    for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.toml"}, QDir::Files, QDir::Name))
        names << file.completeBaseName();
    return names;
}

Result<std::vector<ParameterValue>> ParameterPresets::read(const QString& name, const std::vector<ParameterInfo>& infos,
                                                           std::vector<ParameterValue> values) const {
    const auto found =
        std::find_if(built_in_.begin(), built_in_.end(), [&](const BuiltIn& preset) { return preset.name == name; });
    if (found == built_in_.end()) return readParameterSet(pathOf(name), infos, std::move(values));
    return parameterSetFromText(found->toml, name, infos, std::move(values));
}

Result<void> ParameterPresets::save(const QString& name, const std::vector<ParameterInfo>& infos,
                                    const std::vector<ParameterValue>& values) const {
    // The name becomes a file's: nothing in it may lead out of the folder.
    static const QRegularExpression plain(R"(^[\p{L}\p{N}][\p{L}\p{N} _.-]*$)");
    if (name.size() > longest_name || !plain.match(name).hasMatch())
        return Error{"'" + name.toStdString() + "' is no name; use up to 40 letters, digits, spaces, - _ ."};
    if (builtIn().contains(name))
        return Error{"'" + name.toStdString() + "' comes with the program; take another name"};
    if (folder_.isEmpty() || !QDir().mkpath(folder_))
        return Error{"there is no folder for presets: " + folder_.toStdString()};
    return writeParameterSet(pathOf(name), infos, values);
}

}  // namespace echotrail
