#include "app/io/datagram_seal.hpp"

#include <gtest/gtest.h>

#include <set>

namespace echotrail {
namespace {

using Side = DatagramSeal::Side;

TEST(DatagramSeal, GivesToTheOtherSideWhatWasPutIn) {
    const auto key = DatagramKey::make();
    ASSERT_TRUE(key);
    DatagramSeal tracker(*key, Side::Tracker), console(*key, Side::Console);
    std::set<QByteArray> seen;
    for (const QByteArray& text : {QByteArray("beam"), QByteArray(), QByteArray(1'100, '\0'), QByteArray("beam")}) {
        const QByteArray down = tracker.seal(text), up = console.seal(text);
        EXPECT_EQ(down.size(), text.size() + static_cast<qsizetype>(DatagramSeal::overhead));
        EXPECT_EQ(console.open(down), text);
        EXPECT_EQ(tracker.open(up), text);
        EXPECT_TRUE(seen.insert(down).second && seen.insert(up).second) << "no two are alike";
        EXPECT_EQ(DatagramSeal::sessionOf(down), key->session);
    }
    EXPECT_EQ(console.newest(), 4U);
}

TEST(DatagramSeal, TakesNothingTwiceAndNothingOfItsOwn) {
    const auto key = DatagramKey::make();
    DatagramSeal tracker(*key, Side::Tracker), console(*key, Side::Console);
    const QByteArray first = tracker.seal("first"), second = tracker.seal("second");
    EXPECT_TRUE(console.open(second));
    EXPECT_TRUE(console.open(first)) << "late, but new";
    EXPECT_FALSE(console.open(first));
    EXPECT_FALSE(console.open(second));
    EXPECT_FALSE(tracker.open(second)) << "sent back";
    for (std::uint64_t i = 0; i < 2 * ReplayWindow::width; ++i) EXPECT_TRUE(console.open(tracker.seal("more")));
    EXPECT_FALSE(console.open(first)) << "older than the window";
}

TEST(DatagramSeal, TakesNothingThatWasChangedOrIsUnderAnotherKey) {
    const auto key = DatagramKey::make(), other = DatagramKey::make();
    ASSERT_NE(key->key, other->key);
    DatagramSeal tracker(*key, Side::Tracker), console(*key, Side::Console);
    const QByteArray sealed = tracker.seal("a beam");
    for (qsizetype i = 0; i < sealed.size(); ++i)
        for (const int bit : {0, 7}) {
            QByteArray changed = sealed;
            changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
            EXPECT_FALSE(console.open(changed)) << i;
        }
    for (qsizetype size = 0; size < sealed.size(); ++size) EXPECT_FALSE(console.open(sealed.first(size)));
    EXPECT_FALSE(console.open(sealed + 'x'));
    DatagramSeal stranger(DatagramKey{key->session, other->key}, Side::Tracker);
    EXPECT_FALSE(console.open(stranger.seal("a beam")));
    EXPECT_EQ(console.open(sealed), "a beam") << "none of that has used up its number";
}

}  // namespace
}  // namespace echotrail
