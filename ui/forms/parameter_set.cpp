#include "ui/forms/parameter_set.hpp"

#include <QSaveFile>
#include <algorithm>

namespace echotrail {

namespace {

using Values = Result<std::vector<ParameterValue>>;

Values assigned(const Result<std::vector<ParameterAssignment>>& assignments, const QString& name,
                const std::vector<ParameterInfo>& infos, std::vector<ParameterValue> values) {
    if (!assignments) return Error{assignments.error()};
    for (const ParameterAssignment& assignment : *assignments) {
        const std::string where = name.toStdString() + ":" + std::to_string(assignment.line) + ": ";
        const auto named = std::find_if(infos.begin(), infos.end(),
                                        [&](const ParameterInfo& info) { return info.name == assignment.name; });
        if (named == infos.end()) return Error{where + unknownParameter(assignment.name, infos).message};
        const auto checked = named->checked(assignment.value);
        if (!checked) return Error{where + checked.error()};
        values[static_cast<std::size_t>(named - infos.begin())] = *checked;
    }
    return values;
}

}  // namespace

Values readParameterSet(const QString& path, const std::vector<ParameterInfo>& infos,
                        std::vector<ParameterValue> values) {
    return assigned(readParameterFile(path.toStdString()), path, infos, std::move(values));
}

Values parameterSetFromText(std::string_view text, const QString& name, const std::vector<ParameterInfo>& infos,
                            std::vector<ParameterValue> values) {
    return assigned(readParameterText(text, name.toStdString()), name, infos, std::move(values));
}

Result<void> writeParameterSet(const QString& path, const std::vector<ParameterInfo>& infos,
                               const std::vector<ParameterValue>& values) {
    QSaveFile file(path);
    const auto text = QByteArray::fromStdString(parameterFileText(infos, values));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return Error{path.toStdString() + " could not be written: " + file.errorString().toStdString()};
    return {};
}

}  // namespace echotrail
