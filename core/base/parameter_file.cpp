#include <toml++/toml.h>

#include "core/base/parameters.hpp"

namespace echotrail {
namespace {

Result<void> collect(const toml::table& table, const std::string& path, std::vector<ParameterAssignment>& out) {
    for (const auto& [key, node] : table) {
        const int line = static_cast<int>(node.source().begin.line);
        ParameterAssignment assignment{std::string(key.str()), {}, line};
        if (const auto* inner = node.as_table()) {
            if (auto nested = collect(*inner, path, out); !nested) return nested;
            continue;
        }
        if (const auto* flag = node.as_boolean())
            assignment.value = flag->get();
        else if (const auto* whole = node.as_integer())
            assignment.value = static_cast<double>(whole->get());
        else if (const auto* real = node.as_floating_point())
            assignment.value = real->get();
        else if (const auto* text = node.as_string())
            assignment.value = text->get();
        else
            return Error{path + ":" + std::to_string(line) + ": " + assignment.name +
                         " must be a number, true, false or a quoted word"};
        out.push_back(std::move(assignment));
    }
    return {};
}

/// `parse` gives the table, or throws toml::parse_error.
template <class Parse>
Result<std::vector<ParameterAssignment>> assignmentsFrom(Parse&& parse, const std::string& name) {
    try {
        std::vector<ParameterAssignment> assignments;
        if (auto collected = collect(parse(), name, assignments); !collected) return Error{collected.error()};
        return assignments;
    } catch (const toml::parse_error& error) {
        return Error{name + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description())};
    }
}

}  // namespace

Result<std::vector<ParameterAssignment>> readParameterFile(const std::string& path) {
    return assignmentsFrom([&] { return toml::parse_file(path); }, path);
}

Result<std::vector<ParameterAssignment>> readParameterText(std::string_view text, const std::string& name) {
    return assignmentsFrom([&] { return toml::parse(text); }, name);
}

std::string parameterFileText(const std::vector<ParameterInfo>& infos, const std::vector<ParameterValue>& values) {
    std::string text;
    std::string group;
    for (std::size_t i = 0; i < infos.size(); ++i) {
        const ParameterInfo& info = infos[i];
        if (info.group != group) {
            group = info.group;
            text += (text.empty() ? "[\"" : "\n[\"") + group + "\"]\n";
        }
        std::string limits;
        if (!info.choices.empty())
            for (const std::string& choice : info.choices) limits += (limits.empty() ? "" : ", ") + choice;
        else if (!std::holds_alternative<bool>(info.default_value))
            limits = ParameterInfo::toText(info.minimum) + " to " + ParameterInfo::toText(info.maximum) +
                     (info.unit.empty() ? "" : " " + info.unit);
        text += "# " + info.help + (limits.empty() ? "" : " (" + limits + ")") + "\n";
        const bool quoted = std::holds_alternative<std::string>(values[i]);
        const std::string value = ParameterInfo::toText(values[i]);
        text += info.name + " = " + (quoted ? "\"" + value + "\"" : value) + "\n";
    }
    return text;
}

}  // namespace echotrail
