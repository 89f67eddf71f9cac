#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/result.hpp"

/// Described parameters. A stage keeps what can be tuned in a plain struct `Params` with default member
/// initialisers, and beside it one description per member:
///
///     struct Params { double seed_db = 12.0; int min_beam_hits = 2; };
///     template <> struct Described<Params> {
///         static constexpr std::string_view group = "Detection";
///         static constexpr auto fields = std::tuple{
///             Field{&Params::seed_db, "seed_db", "dB", 3, 40, "Excess over the background a region grows from"}, …};
///     };
///
/// The form, the TOML file, `--set`, `--help` and the log all grow from that description. A pipeline's Params holds
/// its stages' Params; its description lists them as `stages` instead of fields. Names are unique in a pipeline.
namespace echotrail {

/// When a change of a parameter takes effect.
enum class Effect { NextPing, NextSweep };

using ParameterValue = std::variant<bool, int, double, std::string>;

template <class Owner, class Value>
struct Field {
    Value Owner::* member;
    std::string_view name;
    std::string_view unit;  ///< empty for a pure number
    double minimum;         ///< limits are not used for bool and enum
    double maximum;
    std::string_view help;
    Effect effect = Effect::NextPing;
};

/// A switch.
template <class Owner>
constexpr auto flag(bool Owner::* member, std::string_view name, std::string_view help,
                    Effect effect = Effect::NextPing) {
    return Field<Owner, bool>{member, name, "", 0, 1, help, effect};
}

/// One of several named values: an enum whose enumerators count from 0 in the order of `names`.
template <class Owner, class Enum, std::size_t N>
struct ChoiceField {
    Enum Owner::* member;
    std::string_view name;
    std::array<std::string_view, N> names;
    std::string_view help;
    Effect effect = Effect::NextPing;
};

template <class Params>
struct Described;

/// One parameter as the outside sees it.
struct ParameterInfo {
    std::string name;
    std::string group;  ///< the stage it belongs to, as a heading
    std::string unit;
    double minimum = 0;
    double maximum = 0;
    ParameterValue default_value;
    std::vector<std::string> choices;  ///< only of a choice, whose value is a string
    std::string help;
    Effect effect = Effect::NextPing;

    /// "0.5", "true", "high": the value as it is typed and printed, without the unit.
    static std::string toText(const ParameterValue& value);
    /// Reads typed text; the error names the parameter and says what would be accepted.
    Result<ParameterValue> fromText(std::string_view text) const;
    /// Converts to the parameter's own type (a whole number is taken for a real one) and checks the limits.
    Result<ParameterValue> checked(const ParameterValue& value) const;
};

namespace detail {

template <class Params, class Visit>
void forEachField(Params& params, std::string_view group, Visit&& visit) {
    using Plain = std::remove_const_t<Params>;
    if constexpr (requires { Described<Plain>::stages; }) {
        std::apply([&](auto... stage) { (forEachField(params.*stage, "", visit), ...); }, Described<Plain>::stages);
    } else {
        const std::string_view own = group.empty() ? Described<Plain>::group : group;
        std::apply([&](const auto&... field) { (visit(own, field, params.*(field.member)), ...); },
                   Described<Plain>::fields);
    }
}

template <class Owner, class Value>
ParameterValue load(const Field<Owner, Value>&, const Value& value) {
    return ParameterValue(value);
}
template <class Owner, class Enum, std::size_t N>
ParameterValue load(const ChoiceField<Owner, Enum, N>& field, const Enum& value) {
    return std::string(field.names[static_cast<std::size_t>(value)]);
}
template <class Owner, class Value>
void store(const Field<Owner, Value>&, Value& target, const ParameterValue& value) {
    target = std::get<Value>(value);
}
template <class Owner, class Enum, std::size_t N>
void store(const ChoiceField<Owner, Enum, N>& field, Enum& target, const ParameterValue& value) {
    for (std::size_t i = 0; i < N; ++i)
        if (field.names[i] == std::get<std::string>(value)) target = static_cast<Enum>(i);
}

template <class Owner, class Value>
ParameterInfo inform(const Field<Owner, Value>& field) {
    return {std::string(field.name), {}, std::string(field.unit), field.minimum, field.maximum, {}, {},
            std::string(field.help), field.effect};
}
template <class Owner, class Enum, std::size_t N>
ParameterInfo inform(const ChoiceField<Owner, Enum, N>& field) {
    ParameterInfo info{std::string(field.name), {}, {}, 0, 0, {}, {}, std::string(field.help), field.effect};
    info.choices.assign(field.names.begin(), field.names.end());
    return info;
}

}  // namespace detail

/// Every parameter of `Params`, in the order of its description.
template <class Params>
std::vector<ParameterInfo> describeParameters() {
    std::vector<ParameterInfo> all;
    const Params defaults{};
    detail::forEachField(defaults, "", [&](std::string_view group, const auto& field, const auto& value) {
        ParameterInfo info = detail::inform(field);
        info.group = group;
        info.default_value = detail::load(field, value);
        all.push_back(std::move(info));
    });
    return all;
}

/// The value of the parameter called `name`; fails where there is none.
template <class Params>
Result<ParameterValue> parameter(const Params& params, std::string_view name) {
    Result<ParameterValue> found = Error{"no parameter is called " + std::string(name)};
    detail::forEachField(params, "", [&](std::string_view, const auto& field, const auto& value) {
        if (field.name == name) found = detail::load(field, value);
    });
    return found;
}

/// The error for an unknown name, with the nearest known one: "no parameter is called seed_dB; did you mean seed_db?".
Error unknownParameter(std::string_view name, const std::vector<ParameterInfo>& known);

/// Sets one parameter; the limits are checked first, and on failure nothing has changed.
template <class Params>
Result<void> setParameter(Params& params, std::string_view name, const ParameterValue& value) {
    const auto known = describeParameters<Params>();
    for (const ParameterInfo& info : known) {
        if (info.name != name) continue;
        const auto checked = info.checked(value);
        if (!checked) return Error{checked.error()};
        detail::forEachField(params, "", [&](std::string_view, const auto& field, auto& target) {
            if (field.name == name) detail::store(field, target, *checked);
        });
        return {};
    }
    return unknownParameter(name, known);
}

/// Sets one parameter from "NAME=VALUE", as `--set` takes it.
template <class Params>
Result<void> setParameterFromText(Params& params, std::string_view assignment) {
    const auto equals = assignment.find('=');
    if (equals == std::string_view::npos)
        return Error{"'" + std::string(assignment) + "' is not NAME=VALUE"};
    const std::string_view name = assignment.substr(0, equals);
    const auto known = describeParameters<Params>();
    for (const ParameterInfo& info : known) {
        if (info.name != name) continue;
        const auto value = info.fromText(assignment.substr(equals + 1));
        if (!value) return Error{value.error()};
        return setParameter(params, name, *value);
    }
    return unknownParameter(name, known);
}

/// One NAME = VALUE of a parameter file.
struct ParameterAssignment {
    std::string name;
    ParameterValue value;
    int line = 0;
};

/// Reads a TOML parameter file: `name = value`, in tables or not (a table's name is only a heading).
/// Errors say the file, the line and what is wrong.
Result<std::vector<ParameterAssignment>> readParameterFile(const std::string& path);

/// The same from a text; `name` stands for the path in errors.
Result<std::vector<ParameterAssignment>> readParameterText(std::string_view text, const std::string& name);

/// Sets what a recorded parameter text says of `Params`. A name or value that this program does not have is passed
/// over and told in the answer: a recording outlives the program that made it. Fails where it is no TOML at all.
template <class Params>
Result<std::vector<std::string>> applyRecordedParameters(Params& params, std::string_view text) {
    const auto assignments = readParameterText(text, "recorded parameters");
    if (!assignments) return Error{assignments.error()};
    std::vector<std::string> passed_over;
    for (const ParameterAssignment& assignment : *assignments)
        if (const auto set = setParameter(params, assignment.name, assignment.value); !set)
            passed_over.push_back(set.error());
    return passed_over;
}

/// Sets everything a parameter file says; on failure nothing has changed.
template <class Params>
Result<void> applyParameterFile(Params& params, const std::string& path) {
    const auto assignments = readParameterFile(path);
    if (!assignments) return Error{assignments.error()};
    Params changed = params;
    for (const ParameterAssignment& assignment : *assignments) {
        const auto set = setParameter(changed, assignment.name, assignment.value);
        if (!set) return Error{path + ":" + std::to_string(assignment.line) + ": " + set.error()};
    }
    params = changed;
    return {};
}

/// The TOML text that `applyParameterFile` reads back to the same values: one table per group, each
/// parameter with its unit, limits and help as a comment.
std::string parameterFileText(const std::vector<ParameterInfo>& infos, const std::vector<ParameterValue>& values);

template <class Params>
std::vector<ParameterValue> parameterValues(const Params& params);

/// All of `params` as such a text.
template <class Params>
std::string parameterText(const Params& params) {
    return parameterFileText(describeParameters<Params>(), parameterValues(params));
}

/// The values of every parameter, in the order of describeParameters.
template <class Params>
std::vector<ParameterValue> parameterValues(const Params& params) {
    std::vector<ParameterValue> values;
    detail::forEachField(params, "", [&](std::string_view, const auto& field, const auto& value) {
        values.push_back(detail::load(field, value));
    });
    return values;
}

}  // namespace echotrail
