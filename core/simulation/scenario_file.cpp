#include "core/simulation/scenario_file.hpp"

#include "core/simulation/scenario_fields.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace echotrail {

namespace {

/// Where in the file something is wrong: kept until the reader has come back to its start.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    Result<Scenario> read(const toml::table& root);

private:
    Error errorAt(const toml::node& node, const std::string& what) const {
        return Error{file_ + ":" + std::to_string(node.source().begin.line) + ": " + what};
    }

    template <class Part>
    Result<void> set(Part& part, const toml::key& key, const toml::node& node) const {
        ParameterValue value;
        if (const auto* flag = node.as_boolean())
            value = flag->get();
        else if (const auto* whole = node.as_integer())
            value = static_cast<double>(whole->get());
        else if (const auto* real = node.as_floating_point(); real && std::isfinite(real->get()))
            value = real->get();
        else
            return errorAt(node, std::string(key.str()) + " must be a number, true or false");
        if (const auto done = setParameter(part, key.str(), value); !done) return errorAt(node, done.error());
        return {};
    }

    /// Sets all of a table but the keys that are read otherwise.
    template <class Part>
    Result<void> setAll(Part& part, const toml::table& table, std::initializer_list<std::string_view> others) const {
        for (const auto& [key, node] : table) {
            if (std::find(others.begin(), others.end(), key.str()) != others.end()) continue;
            if (const auto done = set(part, key, node); !done) return done;
        }
        return {};
    }

    template <class Part, class ReadOne>
    Result<void> each(const toml::table& root, std::string_view name, std::vector<Part>& parts,
                      const ReadOne& readOne) const {
        const toml::node* node = root.get(name);
        if (!node) return {};
        if (!node->is_array_of_tables())
            return errorAt(*node, std::string(name) + " must be [[" + std::string(name) + "]]");
        for (const toml::node& element : *node->as_array())
            if (const auto done = readOne(parts.emplace_back(), *element.as_table()); !done) return done;
        return {};
    }

    /// Rows of three numbers.
    template <class Take>
    Result<void> triples(const toml::table& table, std::string_view name, const Take& take) const {
        const toml::node* node = table.get(name);
        if (!node) return {};
        if (!node->is_array()) return errorAt(*node, std::string(name) + " must be rows of three numbers");
        for (const toml::node& row : *node->as_array()) {
            const toml::array* cells = row.as_array();
            if (!cells || cells->size() != 3) return errorAt(row, std::string(name) + " must be rows of three numbers");
            std::array<double, 3> numbers{};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto number = (*cells)[i].value<double>();
                if (!number || !std::isfinite(*number) || std::abs(*number) > 1e6)
                    return errorAt(row, std::string(name) + " must be rows of three numbers below a million");
                numbers[i] = *number;
            }
            take(numbers);
        }
        return {};
    }

    Result<void> readTarget(SimulatedTarget& target, const toml::table& table) const;
    Result<void> readText(std::string& text, const toml::table& root, std::string_view name) const;
    Result<void> readPart(auto& part, const toml::table& root, std::string_view name) const;

    std::string file_;
};

Result<void> Reader::readTarget(SimulatedTarget& target, const toml::table& table) const {
    if (const auto done = setAll(target, table, {"path", "fades"}); !done) return done;
    if (const auto done = triples(table, "path",
                                  [&](const auto& row) {
                                      target.path.push_back({row[0], row[1], row[2]});
                                  });
        !done)
        return done;
    if (const auto done = triples(table, "fades",
                                  [&](const auto& row) {
                                      target.fades.push_back({row[0], row[1], row[2]});
                                  });
        !done)
        return done;
    if (target.path.empty()) return errorAt(table, "a target needs a path");
    for (std::size_t i = 1; i < target.path.size(); ++i)
        if (target.path[i].time_s <= target.path[i - 1].time_s) return errorAt(table, "the times of a path must rise");
    const Waypoint &first = target.path.front(), &last = target.path.back();
    if (target.loop && (target.path.size() < 4 || first.north_m != last.north_m || first.east_m != last.east_m))
        return errorAt(table, "a loop needs at least three places and ends where it begins");
    return {};
}

Result<void> Reader::readText(std::string& text, const toml::table& root, std::string_view name) const {
    const auto value = root[name].value<std::string>();
    if (!value || value->empty()) return errorAt(root, std::string(name) + " is missing");
    text = *value;
    return {};
}

Result<void> Reader::readPart(auto& part, const toml::table& root, std::string_view name) const {
    const toml::node* node = root.get(name);
    if (!node) return {};
    if (!node->is_table()) return errorAt(*node, std::string(name) + " must be a table");
    return setAll(part, *node->as_table(), {});
}

/// What makes a scenario one that cannot be simulated, as words; nothing where it can.
std::optional<std::string> faultOf(const Scenario& scenario) {
    const double steps = 2.0 * scenario.sector_half_width_deg / scenario.step_deg;
    if (steps < 0.5 || std::abs(steps - std::round(steps)) > 1e-6)
        return "the sector must be a whole number of steps wide";
    if (scenario.altitude_m - scenario.altitude_swing_m < 0.1) return "the bottom rises to the head";
    if (scenario.water_depth_m <= scenario.altitude_m) return "the head is above the water";
    if (scenario.vehicle.follow_lag_s > 0.0 && scenario.targets.empty()) return "the vehicle has no target to follow";
    if (scenario.navigation.least_latency_s > scenario.navigation.most_latency_s)
        return "the least latency is above the greatest";
    const Pose start = vehiclePose(scenario, 0.0);
    if (std::hypot(start.north_m, start.east_m) > 0.01)
        return "the vehicle must begin at the origin: the path must pass 0, 0 at minus follow_lag_s";
    return std::nullopt;
}

Result<Scenario> Reader::read(const toml::table& root) {
    Scenario scenario;
    const auto readEach = [&](auto& part, const toml::table& table) { return setAll(part, table, {}); };
    const auto readOneTarget = [&](SimulatedTarget& target, const toml::table& table) {
        return readTarget(target, table);
    };
    for (const Result<void>& done :
         {readText(scenario.name, root, "name"), readText(scenario.description, root, "description"),
          setAll(scenario, root,
                 {"name", "description", "vehicle", "navigation", "targets", "debris", "debris_fields"}),
          readPart(scenario.vehicle, root, "vehicle"), readPart(scenario.navigation, root, "navigation"),
          each(root, "targets", scenario.targets, readOneTarget), each(root, "debris", scenario.debris, readEach),
          each(root, "debris_fields", scenario.debris_fields, readEach)})
        if (!done) return Error{done.error()};
    if (const auto fault = faultOf(scenario)) return errorAt(root, *fault);
    return scenario;
}

}  // namespace

Result<Scenario> readScenario(std::string_view text, const std::string& file) {
    try {
        return Reader(file).read(toml::parse(text));
    } catch (const toml::parse_error& error) {
        return Error{file + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description())};
    }
}

const std::vector<Scenario>& scenarios() {
    static const std::vector<Scenario> all = [] {
        std::vector<Scenario> read;
        for (const ScenarioText& text : scenarioTexts()) {
            auto scenario = readScenario(text.toml, std::string(text.file));
            assert(scenario && "a scenario of the library is damaged");
            if (scenario) read.push_back(*std::move(scenario));
        }
        return read;
    }();
    return all;
}

}  // namespace echotrail
