#pragma once

#include "core/base/parameters.hpp"
#include "core/detection/echo_conditioner.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace echotrail {

struct EchoScreenParams {
    double seed_excess_db = 12.0;
    double interest_lowering_db = 4.0;
    double blank_range_m = 1.5;
};

template <>
struct Described<EchoScreenParams> {
    static constexpr std::string_view group = "Detection";
    static constexpr auto fields =
        std::tuple{Field{&EchoScreenParams::seed_excess_db, "seed_excess_db", "dB", 3, 40,
                         "How far an echo must stand out from its background for a region to grow from it"},
                   Field{&EchoScreenParams::interest_lowering_db, "interest_lowering_db", "dB", 0, 12,
                         "Where a followed object is expected, an echo may be this much weaker"},
                   Field{&EchoScreenParams::blank_range_m, "blank_range_m", "m", 0, 20,
                         "Nearer than this only expected objects are detected: the transducer still rings"}};
};

/// A stretch of range, in metres, where a followed object is expected at the present bearing.
struct RangeOfInterest {
    double near_m = 0.0;
    double far_m = 0.0;
};

/// A patch of consecutive pings and cells that holds at least one strong echo: worth growing regions in.
struct Candidate {
    std::uint64_t first_ping = 0;  ///< row numbers as counted by EchoScreen, inclusive
    std::uint64_t last_ping = 0;
    int first_cell = 0;
    int last_cell = 0;
    bool of_interest = false;  ///< some of it was found with the lowered threshold's help or inside an interest
};

/// Finds strong echoes as the pings come in: runs of cells above the threshold, joined from ping to ping where they
/// touch or nearly touch. It decides where to look closer and when the beam has left a thing; the regions themselves
/// are grown afterwards, in a small picture.
/// Order: rows in time order; endSweep() where the beam turns round.
/// State: the candidates that the beam is still on.
class EchoScreen {
public:
    /// A candidate is complete when this many pings have gone by without a strong echo touching it; so its picture
    /// has its flanks, too.
    static constexpr int closing_pings = 2;
    /// A wider one is cut: a bank or the bottom, which has no end.
    static constexpr int max_pings = 96;

    explicit EchoScreen(const EchoScreenParams& params) : params_(params) {}
    void setParams(const EchoScreenParams& params) { params_ = params; }

    /// Takes in one row; appends the candidates it completes to `closed`. Rows count from 0.
    void add(const EchoRow& row, std::span<const RangeOfInterest> interests, std::vector<Candidate>& closed);
    /// Completes all that is open.
    void endSweep(std::vector<Candidate>& closed);

    /// Whether the beam is still on something between these ranges.
    bool isOpenWithin(double near_m, double far_m) const;
    /// What the last row's cells had to exceed their background by, in levels; 255 where nothing is detected.
    std::span<const std::uint8_t> lastThreshold() const { return threshold_; }
    /// The first row of the oldest echo the beam is still on; the next row's number where there is none.
    std::uint64_t oldestOpenRow() const;

private:
    struct Run {
        int first_cell, last_cell;
        bool of_interest;
    };
    struct Open {
        Candidate candidate;
        std::vector<Run> front;  ///< runs of the last ping that touched it
        std::vector<Run> next;   ///< the front in the making, while a ping is taken in
    };
    void findRuns(const EchoRow& row, std::span<const RangeOfInterest> interests);
    void join(const Run& run);

    EchoScreenParams params_;
    std::uint64_t rows_ = 0;
    double cell_m_ = 0.0;
    std::vector<std::uint8_t> threshold_;
    std::vector<Run> runs_;
    std::vector<Open> open_;
};

}  // namespace echotrail
