#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace echotrail {

/// Which rows of a table there are: ranges of numbers, from 1, that neither touch nor overlap.
class RowRanges {
public:
    using Range = std::pair<std::int64_t, std::int64_t>;  ///< the first and the last

    void add(std::int64_t first, std::int64_t last) {
        if (first > last) return;
        auto next = ranges_.upper_bound(first);
        if (next != ranges_.begin() && std::prev(next)->second >= first - 1) first = (--next)->first;
        while (next != ranges_.end() && next->first <= last + 1) {
            last = std::max(last, next->second);
            next = ranges_.erase(next);
        }
        ranges_[first] = last;
    }
    /// The first rows between `from` and `last` that there are not.
    std::optional<Range> missing(std::int64_t from, std::int64_t last) const {
        const auto after = ranges_.upper_bound(from);
        if (after != ranges_.begin()) from = std::max(from, std::prev(after)->second + 1);
        if (after != ranges_.end()) last = std::min(last, after->first - 1);
        if (from <= last) return Range{from, last};
        return std::nullopt;
    }
    std::int64_t count() const {
        std::int64_t rows = 0;
        for (const auto& [first, last] : ranges_) rows += last - first + 1;
        return rows;
    }
    std::int64_t last() const { return ranges_.empty() ? 0 : ranges_.rbegin()->second; }
    /// Where the last range begins; 1 where there is none.
    std::int64_t lastBegins() const { return ranges_.empty() ? 1 : ranges_.rbegin()->first; }
    /// Nothing is missing before the last.
    bool whole() const { return ranges_.empty() || (ranges_.size() == 1 && ranges_.begin()->first == 1); }
    const std::map<std::int64_t, std::int64_t>& ranges() const { return ranges_; }

private:
    std::map<std::int64_t, std::int64_t> ranges_;
};

}  // namespace echotrail
