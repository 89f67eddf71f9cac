#include "core/link/send_queue.hpp"

#include "core/link/link_limits.hpp"
#include "tests/core/link/sample_values.hpp"

#include <gtest/gtest.h>

namespace echotrail {
namespace {

using test::at;
using Lane = SendQueue::Lane;

constexpr std::size_t plenty = 1 << 24;

SendQueue::Frame frame(std::size_t size, char letter = 'x') {
    return std::make_shared<const std::string>(size, letter);
}

std::string taken(SendQueue& queue, double seconds, std::size_t room = plenty) {
    std::string out;
    queue.take(out, room, at(seconds));
    return out;
}

TEST(SendQueue, TheHigherLaneGoesFirstAndWhatIsBegunIsFinished) {
    SendQueue queue;
    queue.add(Lane::Picture, frame(4, 'p'), at(0));
    queue.add(Lane::Particles, frame(4, 'c'), at(0));
    EXPECT_EQ(taken(queue, 0.0, 2), "cc");
    queue.add(Lane::Urgent, frame(4, 'u'), at(0));
    queue.add(Lane::Regions, frame(4, 'r'), at(0));
    EXPECT_EQ(taken(queue, 0.0), "ccuuuurrrrpppp");
    EXPECT_TRUE(queue.empty());
}

TEST(SendQueue, APictureThatNobodyTakesDropsItsOldestAndStaysBounded) {
    SendQueue queue;
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(queue.add(Lane::Picture, frame(100'000), at(0)));
    EXPECT_LE(queue.waitingBytes(), link_limits::picture_bytes);
    EXPECT_GT(queue.counts().left_out, 70U);
}

TEST(SendQueue, WithoutRoomForWhatMustArriveAllIsThrownAwayAndSaid) {
    SendQueue queue;
    queue.add(Lane::Picture, frame(1000), at(0));
    bool all = true;
    for (int i = 0; i < 100 && all; ++i) all = queue.add(Lane::Urgent, frame(100'000), at(0));
    EXPECT_FALSE(all);
    EXPECT_TRUE(queue.empty());
    EXPECT_EQ(queue.counts().overflows, 1U);
}

TEST(SendQueue, WhatIsUnderWayWhenAllIsThrownAwayIsStillFinished) {
    SendQueue queue;
    queue.add(Lane::Urgent, frame(10, 'a'), at(0));
    EXPECT_EQ(taken(queue, 0.0, 3), "aaa");
    queue.clear();
    EXPECT_EQ(taken(queue, 0.0), "aaaaaaa");
}

/// A way that carries so many bytes in a step of 0.1 s; each step adds one frame to every lane.
SendQueue::Level levelAfter(SendQueue& queue, double seconds, std::size_t room, double from = 0.0) {
    for (double t = from; t < from + seconds; t += 0.1) {
        queue.add(Lane::Urgent, frame(100, 'u'), at(t));
        for (const Lane lane : {Lane::Regions, Lane::Particles, Lane::Picture}) queue.add(lane, frame(1000), at(t));
        taken(queue, t, room);
    }
    return queue.level();
}

TEST(SendQueue, LessIsSentStepByStepInTheDeclaredOrderAndMoreAgainLater) {
    SendQueue queue;
    EXPECT_EQ(levelAfter(queue, 5.0, plenty), SendQueue::Everything);
    SendQueue::Level before = queue.level();
    double t = 5.0;
    for (; t < 15.0; t += 0.1) {
        levelAfter(queue, 0.05, 150, t);
        const SendQueue::Level now = queue.level();
        EXPECT_TRUE(now == before || now == before + 1) << "one step at a time";
        before = now;
    }
    EXPECT_EQ(queue.level(), SendQueue::NoPicture);
    EXPECT_EQ(levelAfter(queue, 4.0, plenty, t), SendQueue::NoPicture) << "not at once";
    EXPECT_EQ(levelAfter(queue, 40.0, plenty, t + 4.0), SendQueue::Everything);
}

TEST(SendQueue, WhatMustArriveIsNeverLeftOutOfASlowWay) {
    SendQueue queue;
    std::size_t urgent = 0;
    for (double t = 0.0; t < 30.0; t += 0.1) {
        queue.add(Lane::Urgent, frame(100, 'u'), at(t));
        queue.add(Lane::Picture, frame(200, 'p'), at(t));
        const std::string out = taken(queue, t, 120);
        urgent += static_cast<std::size_t>(std::count(out.begin(), out.end(), 'u'));
    }
    EXPECT_GT(urgent, 290U * 100U);
}

TEST(SendQueue, AnOldPictureIsNotWorthSending) {
    SendQueue queue;
    queue.add(Lane::Picture, frame(10, 'o'), at(0));
    queue.add(Lane::Urgent, frame(10, 'u'), at(0));
    queue.judge(at(2.5));
    queue.add(Lane::Picture, frame(10, 'n'), at(2.5));
    EXPECT_EQ(taken(queue, 2.5), std::string(10, 'u') + std::string(10, 'n'));
}

TEST(SendQueue, ALimitedRateIsKeptOnAverage) {
    SendQueue queue;
    queue.setRate(8000.0, at(0));
    std::size_t sent = 0;
    for (double t = 0.0; t < 10.0; t += 0.02) {
        queue.add(Lane::Urgent, frame(1000), at(t));
        sent += taken(queue, t).size();
    }
    EXPECT_NEAR(static_cast<double>(sent), 80'000.0, 2'500.0);
}

TEST(SendQueue, ItSaysHowLongNothingCouldBeSent) {
    SendQueue queue;
    EXPECT_EQ(queue.stuckFor(at(100)), Microseconds(0)) << "nothing waits";
    queue.add(Lane::Urgent, frame(1000), at(100));
    queue.add(Lane::Urgent, frame(1000), at(104));
    EXPECT_EQ(queue.stuckFor(at(105)), Microseconds(5'000'000));
    taken(queue, 105.0, 1);
    EXPECT_EQ(queue.stuckFor(at(106)), Microseconds(1'000'000));
}

}  // namespace
}  // namespace echotrail
