#include "core/detection/echo_screen.hpp"

#include <algorithm>
#include <cmath>

namespace echotrail {
namespace {

constexpr int bridged_cells = 2;  // a gap this short within a ping, or offset between pings, does not part an echo

int levelsFromDb(double db) { return static_cast<int>(std::lround(db * levels_per_db)); }

bool touches(int first_a, int last_a, int first_b, int last_b) {
    return first_a <= last_b + bridged_cells && first_b <= last_a + bridged_cells;
}

}  // namespace

void EchoScreen::findRuns(const EchoRow& row, std::span<const RangeOfInterest> interests) {
    constexpr int never = 255;  // marks cells that are not looked at
    const int cells = static_cast<int>(row.level.size());
    const auto cellAt = [&](double range_m) {
        return std::clamp(static_cast<int>(std::floor(range_m / cell_m_)), 0, cells);
    };
    threshold_.assign(cells, static_cast<std::uint8_t>(levelsFromDb(params_.seed_excess_db)));
    std::fill_n(threshold_.begin(), cellAt(params_.blank_range_m), static_cast<std::uint8_t>(never));
    const int lowered = std::max(levelsFromDb(params_.seed_excess_db - params_.interest_lowering_db), 1);
    for (const RangeOfInterest& interest : interests)
        for (int i = cellAt(interest.near_m); i < std::min(cellAt(interest.far_m) + 1, cells); ++i)
            threshold_[i] = static_cast<std::uint8_t>(lowered);

    runs_.clear();
    for (int i = 0; i < cells; ++i) {
        if (row.smooth[i] - row.background[i] < threshold_[i] || threshold_[i] == never) continue;
        const bool of_interest = threshold_[i] == lowered;
        if (!runs_.empty() && i <= runs_.back().last_cell + 1 + bridged_cells) {
            runs_.back().last_cell = i;
            runs_.back().of_interest |= of_interest;
        } else {
            runs_.push_back({i, i, of_interest});
        }
    }
}

/// Adds a run of the present ping to the open candidate it touches; where it touches several, they become one.
void EchoScreen::join(const Run& run) {
    Open* home = nullptr;
    for (auto it = open_.begin(); it != open_.end();) {
        const bool meets = std::any_of(it->front.begin(), it->front.end(), [&](const Run& other) {
            return touches(run.first_cell, run.last_cell, other.first_cell, other.last_cell);
        });
        if (!meets) {
            ++it;
        } else if (!home) {
            home = &*it++;
        } else {
            Candidate& into = home->candidate;
            into.first_ping = std::min(into.first_ping, it->candidate.first_ping);
            into.first_cell = std::min(into.first_cell, it->candidate.first_cell);
            into.last_cell = std::max(into.last_cell, it->candidate.last_cell);
            into.last_ping = std::max(into.last_ping, it->candidate.last_ping);
            into.of_interest |= it->candidate.of_interest;
            home->front.insert(home->front.end(), it->front.begin(), it->front.end());
            home->next.insert(home->next.end(), it->next.begin(), it->next.end());
            it = open_.erase(it);  // `home` lies before `it` and stays where it is
        }
    }
    if (!home) home = &open_.emplace_back(Open{{rows_, rows_, run.first_cell, run.last_cell, false}, {}, {}});
    Candidate& candidate = home->candidate;
    candidate.last_ping = rows_;
    candidate.first_cell = std::min(candidate.first_cell, run.first_cell);
    candidate.last_cell = std::max(candidate.last_cell, run.last_cell);
    candidate.of_interest |= run.of_interest;
    home->next.push_back(run);
}

void EchoScreen::add(const EchoRow& row, std::span<const RangeOfInterest> interests, std::vector<Candidate>& closed) {
    if (row.cell_m != cell_m_) endSweep(closed);  // cells of another size cannot be joined to the open ones
    cell_m_ = row.cell_m;
    if (!row.level.empty()) {
        findRuns(row, interests);
        for (const Run& run : runs_) join(run);
    }
    for (Open& open : open_) {
        if (open.next.empty()) continue;
        open.front.swap(open.next);
        open.next.clear();
    }
    std::erase_if(open_, [&](const Open& open) {
        const bool done =
            rows_ >= open.candidate.last_ping + closing_pings || rows_ >= open.candidate.first_ping + max_pings;
        if (done) closed.push_back(open.candidate);
        return done;
    });
    ++rows_;
}

void EchoScreen::endSweep(std::vector<Candidate>& closed) {
    for (const Open& open : open_) closed.push_back(open.candidate);
    open_.clear();
}

std::uint64_t EchoScreen::oldestOpenRow() const {
    std::uint64_t oldest = rows_;
    for (const Open& open : open_) oldest = std::min(oldest, open.candidate.first_ping);
    return oldest;
}

bool EchoScreen::isOpenWithin(double near_m, double far_m) const {
    return std::any_of(open_.begin(), open_.end(), [&](const Open& open) {
        return open.candidate.first_cell * cell_m_ <= far_m && (open.candidate.last_cell + 1) * cell_m_ >= near_m;
    });
}

}  // namespace echotrail
