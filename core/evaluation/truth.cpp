#include "core/evaluation/truth.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace echotrail {
namespace {

constexpr int most_targets = 64;
constexpr std::string_view place_header = "t,target,north_m,east_m,velocity_north_mps,velocity_east_mps,visible";
constexpr std::string_view sight_header = "t,target,range_m,bearing_deg,visible";

std::optional<std::vector<double>> numbersOf(std::string_view line, std::size_t count) {
    std::vector<double> numbers;
    while (numbers.size() < count) {
        const std::size_t comma = std::min(line.find(','), line.size());
        double number = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + comma, number);
        if (error != std::errc() || end != line.data() + comma || !std::isfinite(number)) return std::nullopt;
        numbers.push_back(number);
        if (comma == line.size()) {
            line = {};
            break;
        }
        line.remove_prefix(comma + 1);
    }
    if (numbers.size() != count || !line.empty()) return std::nullopt;
    return numbers;
}

Truth::Sample between(const Truth::Sample& a, const Truth::Sample& b, Timestamp time) {
    const double span = secondsBetween(a.time, b.time);
    const double u = span > 0 ? secondsBetween(a.time, time) / span : 0.0;
    Truth::Sample sample = u < 0.5 ? a : b;
    sample.time = time;
    sample.position_m = (1 - u) * a.position_m + u * b.position_m;
    sample.velocity_mps = (1 - u) * a.velocity_mps + u * b.velocity_mps;
    sample.range_m = (1 - u) * a.range_m + u * b.range_m;
    sample.from_bow = a.from_bow + u * (b.from_bow - a.from_bow);
    return sample;
}

}  // namespace

Truth::Truth(const std::vector<TruthSample>& samples) {
    for (const TruthSample& sample : samples) {
        samples_.resize(std::max<std::size_t>(samples_.size(), sample.target + 1));
        samples_[sample.target].push_back({.time = sample.time,
                                           .has_place = true,
                                           .position_m = {sample.north_m, sample.east_m},
                                           .velocity_mps = {sample.velocity_north_mps, sample.velocity_east_mps},
                                           .has_sight = true,
                                           .range_m = sample.range_m,
                                           .from_bow = sample.from_bow,
                                           .visible = sample.visible});
    }
}

Result<Truth> Truth::read(std::string_view csv, Timestamp start) {
    Truth truth;
    bool places = false;
    int number = 0;
    while (!csv.empty()) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        std::string_view line = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        const auto wrong = [&](const std::string& what) {
            return Error{"truth, line " + std::to_string(number) + ": " + what};
        };
        if (++number == 1) {
            places = line == place_header;
            if (!places && line != sight_header)
                return wrong("the header has to be '" + std::string(place_header) + "' or '" +
                             std::string(sight_header) + "'");
            continue;
        }
        if (line.empty()) continue;
        const auto v = numbersOf(line, places ? 7 : 5);
        if (!v) return wrong("there have to be " + std::to_string(places ? 7 : 5) + " numbers");
        const double target = (*v)[1];
        if (target != std::floor(target) || target < 0 || target >= most_targets)
            return wrong("targets are numbered from 0 to " + std::to_string(most_targets - 1));
        if (std::abs((*v)[0]) > 1e7) return wrong("the time is not believable");
        Sample sample{.time = start + microsecondsFromSeconds((*v)[0]), .visible = v->back() != 0};
        if (places) {
            sample.has_place = true;
            sample.position_m = {(*v)[2], (*v)[3]};
            sample.velocity_mps = {(*v)[4], (*v)[5]};
        } else {
            sample.has_sight = true;
            sample.range_m = (*v)[2];
            sample.from_bow = Bearing::degrees((*v)[3]);
        }
        const auto index = static_cast<std::size_t>(target);
        truth.samples_.resize(std::max(truth.samples_.size(), index + 1));
        auto& series = truth.samples_[index];
        if (!series.empty() && sample.time < series.back().time) return wrong("times have to rise");
        series.push_back(sample);
    }
    if (truth.samples_.empty()) return Error{"the truth file holds no targets"};
    return truth;
}

bool Truth::hasVelocities() const {
    return std::all_of(samples_.begin(), samples_.end(),
                       [](const auto& series) { return series.empty() || series.front().has_place; });
}

std::optional<Truth::Sample> Truth::at(int target, Timestamp time) const {
    if (target < 0 || target >= targets()) return std::nullopt;
    const auto& series = samples_[static_cast<std::size_t>(target)];
    const auto next = std::lower_bound(series.begin(), series.end(), time,
                                       [](const Sample& sample, Timestamp t) { return sample.time < t; });
    if (next == series.end()) return std::nullopt;
    if (next->time == time) return *next;
    if (next == series.begin()) return std::nullopt;
    return between(*(next - 1), *next, time);
}

}  // namespace echotrail
