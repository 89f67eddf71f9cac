#include "core/base/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace echotrail {
namespace {

std::string realText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;  // shortest that reads back
    return std::string(text.data(), end);
}

std::string limitsText(const ParameterInfo& info) {
    if (!info.choices.empty()) {
        std::string text = "one of";
        for (const std::string& choice : info.choices) text += " " + choice;
        return text;
    }
    if (std::holds_alternative<bool>(info.default_value)) return "true or false";
    std::string text = std::holds_alternative<int>(info.default_value) ? "a whole number " : "a number ";
    text += "from " + realText(info.minimum) + " to " + realText(info.maximum);
    if (!info.unit.empty()) text += " " + info.unit;
    return text;
}

Error refused(const ParameterInfo& info, std::string_view given) {
    return {info.name + " cannot be " + std::string(given) + "; it takes " + limitsText(info)};
}

/// Levenshtein distance: the number of single-character edits between two words.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string ParameterInfo::toText(const ParameterValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<int>(&value)) return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&value)) return realText(*real);
    return std::get<std::string>(value);
}

Result<ParameterValue> ParameterInfo::fromText(std::string_view text) const {
    if (!choices.empty()) return checked(std::string(text));
    if (std::holds_alternative<bool>(default_value)) {
        if (text == "true" || text == "1" || text == "on") return ParameterValue(true);
        if (text == "false" || text == "0" || text == "off") return ParameterValue(false);
        return refused(*this, text);
    }
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size()) return refused(*this, text.empty() ? "empty" : text);
    return checked(value);
}

Result<ParameterValue> ParameterInfo::checked(const ParameterValue& value) const {
    if (!choices.empty()) {
        const auto* word = std::get_if<std::string>(&value);
        if (word && std::find(choices.begin(), choices.end(), *word) != choices.end()) return value;
        return refused(*this, toText(value));
    }
    if (std::holds_alternative<bool>(default_value)) {
        if (std::holds_alternative<bool>(value)) return value;
        return refused(*this, toText(value));
    }
    double number = 0;
    if (const auto* whole = std::get_if<int>(&value))
        number = *whole;
    else if (const auto* real = std::get_if<double>(&value))
        number = *real;
    else
        return refused(*this, toText(value));
    if (!(number >= minimum && number <= maximum)) return refused(*this, toText(value));  // also refuses NaN
    if (std::holds_alternative<double>(default_value)) return ParameterValue(number);
    if (number != std::floor(number)) return refused(*this, toText(value));
    return ParameterValue(static_cast<int>(number));
}

Error unknownParameter(std::string_view name, const std::vector<ParameterInfo>& known) {
    std::string message = "no parameter is called '" + std::string(name) + "'";
    const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
        return editDistance(a.name, name) < editDistance(b.name, name);
    });
    if (nearest != known.end() && editDistance(nearest->name, name) <= nearest->name.size() / 2)
        message += "; did you mean " + nearest->name + "?";
    return {message};
}

}  // namespace echotrail
