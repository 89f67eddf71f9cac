#include "core/runtime/latest.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace echotrail {
namespace {

TEST(Latest, HandsOutTheNewestValueOnce) {
    Latest<int> box;
    EXPECT_TRUE(box.empty());
    box.put(1);
    box.put(2);
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.take(), 2);
    EXPECT_EQ(box.take(), std::nullopt);
}

TEST(Latest, AReaderInAnotherThreadSeesValuesInOrderAndTheLastOne) {
    Latest<int> box;
    constexpr int last = 20000;
    std::jthread writer([&] {
        for (int i = 1; i <= last; ++i) box.put(i);
    });
    int seen = 0;
    while (seen < last) {
        if (const auto value = box.take()) {
            ASSERT_GT(*value, seen);
            seen = *value;
        }
    }
}

}  // namespace
}  // namespace echotrail
