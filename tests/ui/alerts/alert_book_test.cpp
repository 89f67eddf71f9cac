#include "ui/alerts/alert_book.hpp"

#include "ui/alerts/alert_log.hpp"
#include "ui/alerts/alert_sound.hpp"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

namespace echotrail {
namespace {

Timestamp at(double seconds) {
    return Timestamp{std::chrono::seconds(1'274'601'600)} + microsecondsFromSeconds(seconds);
}

const Situation lost{"track_lost/3", AlertPriority::Alarm, "T03 lost", "expected at 36.8 m"};
const Situation heading{"heading", AlertPriority::Warning, "No heading", "tracks coast", 1.0};
const Situation disk{"disk", AlertPriority::Caution, "Disk nearly full", "1.9 GB free"};

QStringList titles(const AlertBook& book) {
    QStringList all;
    for (const Alert& alert : book.alerts()) all << alert.situation.title;
    return all;
}

class AlertBookTest : public testing::Test {
protected:
    AlertBook book_;
};

TEST_F(AlertBookTest, OneSituationIsOneAlertHoweverOftenItIsSeen) {
    for (int i = 0; i < 10; ++i) book_.update({lost}, at(i));
    ASSERT_EQ(book_.alerts().size(), 1U);
    EXPECT_EQ(book_.alerts()[0].raised, at(0));
    EXPECT_TRUE(book_.alerts()[0].isNew());
    EXPECT_EQ(book_.takeChanges().size(), 1U);
}

TEST_F(AlertBookTest, WhatDoesNotLastIsNotTold) {
    book_.update({heading}, at(0.0));
    book_.update({heading}, at(0.9));
    EXPECT_TRUE(book_.alerts().empty());
    book_.update({}, at(0.95));
    book_.update({heading}, at(1.0));
    EXPECT_TRUE(book_.alerts().empty()) << "it has to last a second in one piece";
    book_.update({heading}, at(2.0));
    EXPECT_EQ(book_.alerts().size(), 1U);
}

TEST_F(AlertBookTest, WhatIsGoneForAMomentIsNotOver) {
    book_.update({heading}, at(0));
    book_.update({heading}, at(1));
    book_.update({}, at(5));
    EXPECT_FALSE(book_.alerts()[0].ended);
    book_.update({heading}, at(5.5));
    book_.update({}, at(6));
    book_.update({}, at(7));
    EXPECT_EQ(book_.alerts()[0].ended, at(7));
}

TEST_F(AlertBookTest, WhatIsOverAsksUntilItIsAcknowledged) {
    book_.update({lost}, at(0));
    book_.update({}, at(3));
    ASSERT_NE(book_.mostUrgent(), nullptr) << "the operator was away: it happened all the same";
    book_.update({lost}, at(4));
    EXPECT_EQ(book_.alerts().size(), 1U) << "it came back before anyone looked: the same one";
    book_.update({}, at(5));
    book_.acknowledge(book_.mostUrgent()->id, at(6));
    EXPECT_EQ(book_.mostUrgent(), nullptr);
    EXPECT_FALSE(book_.alerts()[0].isOpen());
    book_.update({lost}, at(7));
    EXPECT_EQ(book_.alerts().size(), 2U) << "now it is another one";
}

TEST_F(AlertBookTest, AWarningThatNobodyAcknowledgesBecomesAnAlarm) {
    book_.update({heading}, at(0));
    book_.update({heading}, at(1));
    book_.update({heading}, at(60.9));
    EXPECT_EQ(book_.alerts()[0].priority, AlertPriority::Warning);
    book_.update({heading}, at(61));
    EXPECT_EQ(book_.alerts()[0].priority, AlertPriority::Alarm);
    EXPECT_EQ(book_.alerts().size(), 1U);
}

TEST_F(AlertBookTest, AnAcknowledgedWarningIsLeftAlone) {
    book_.update({heading}, at(0));
    book_.update({heading}, at(1));
    book_.acknowledge(1, at(2));
    book_.update({heading}, at(500));
    EXPECT_EQ(book_.alerts()[0].priority, AlertPriority::Warning);
}

TEST_F(AlertBookTest, WhatGetsWorseAsksAnew) {
    book_.update({heading}, at(0));
    book_.update({heading}, at(1));
    book_.acknowledge(1, at(2));
    Situation worse = heading;
    worse.priority = AlertPriority::Alarm;
    book_.update({worse}, at(3));
    ASSERT_NE(book_.mostUrgent(), nullptr);
    EXPECT_EQ(book_.mostUrgent()->priority, AlertPriority::Alarm);
}

TEST_F(AlertBookTest, ACautionAsksNothing) {
    book_.update({disk}, at(0));
    EXPECT_EQ(book_.mostUrgent(), nullptr);
    EXPECT_TRUE(book_.alerts()[0].isOpen());
    book_.update({}, at(1));
    EXPECT_FALSE(book_.alerts()[0].isOpen());
}

TEST_F(AlertBookTest, TheMostUrgentIsOnTopThenTheNewest) {
    book_.update({disk}, at(0));
    book_.update({disk, lost}, at(1));
    Situation other = lost;
    other.key = "track_lost/4";
    other.title = "T04 lost";
    book_.update({disk, lost, other}, at(2));
    EXPECT_EQ(titles(book_), (QStringList{"T04 lost", "T03 lost", "Disk nearly full"}));
    book_.acknowledge(book_.mostUrgent()->id, at(3));
    EXPECT_EQ(titles(book_), (QStringList{"T03 lost", "T04 lost", "Disk nearly full"}));
    EXPECT_EQ(book_.recent(at(601.5)), 1) << "within ten minutes";
}

TEST_F(AlertBookTest, AHappeningStaysUntilAcknowledged) {
    const Situation entry{"guard/1/2", AlertPriority::Alarm, "T02 in guard zone 1", ""};
    book_.happened(entry, at(0));
    book_.happened(entry, at(1));
    book_.update({}, at(100));
    ASSERT_EQ(book_.alerts().size(), 1U);
    EXPECT_TRUE(book_.alerts()[0].isOpen());
    book_.acknowledge(1, at(101));
    EXPECT_FALSE(book_.alerts()[0].isOpen());
    book_.happened(entry, at(102));
    EXPECT_EQ(book_.alerts().size(), 2U);
}

TEST_F(AlertBookTest, AFloodForgetsWhatIsOverAndNothingElse) {
    for (int i = 0; i < 1000; ++i) {
        Situation each = disk;
        each.key = QString::number(i);
        book_.update({lost, each}, at(i));
    }
    EXPECT_LE(book_.alerts().size(), AlertBook::most_alerts);
    EXPECT_EQ(book_.mostUrgent()->situation.title, "T03 lost");
}

TEST(AlertSounds, RepeatUntilAcknowledgedAndSilenceIsForATime) {
    AlertBook book;
    AlertSound sound;
    EXPECT_FALSE(sound.isDue(book, at(0)));
    book.update({lost}, at(0));
    EXPECT_TRUE(sound.isDue(book, at(0)));
    EXPECT_FALSE(sound.isDue(book, at(1.9)));
    EXPECT_TRUE(sound.isDue(book, at(2)));
    sound.silence(at(3));
    EXPECT_FALSE(sound.isDue(book, at(32.9)));
    EXPECT_TRUE(sound.isDue(book, at(33)));
    book.acknowledge(1, at(34));
    EXPECT_FALSE(sound.isDue(book, at(40)));
}

TEST(AlertSounds, WhatIsNewEndsTheSilence) {
    AlertBook book;
    AlertSound sound;
    book.update({lost}, at(0));
    sound.silence(at(1));
    Situation other = lost;
    other.key = "track_lost/4";
    book.update({lost, other}, at(2));
    EXPECT_TRUE(sound.isDue(book, at(2)));
    EXPECT_EQ(sound.silentFor(at(2)), 0.0);
}

TEST(AlertSounds, ACautionIsQuiet) {
    AlertBook book;
    AlertSound sound;
    book.update({disk}, at(0));
    EXPECT_FALSE(sound.isDue(book, at(0)));
}

TEST(AlertLogs, SayWhatBecameOfEachAlertALineEach) {
    const QTemporaryDir folder;
    const AlertLog log(folder.filePath("deep/alerts.log"));
    AlertBook book;
    Situation odd = lost;
    odd.cause = "two\nlines";
    book.update({odd}, at(0));
    book.acknowledge(1, at(1.5));
    book.update({}, at(2));
    ASSERT_TRUE(log.write(book.takeChanges()));
    QFile file(log.path());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts);
    ASSERT_EQ(lines.size(), 3);
    EXPECT_EQ(lines[0], "2010-05-23T08:00:00.000Z raised alarm track_lost/3: T03 lost. two lines");
    EXPECT_EQ(lines[1], "2010-05-23T08:00:01.500Z acknowledged alarm track_lost/3: T03 lost. two lines");
    EXPECT_TRUE(lines[2].contains(" ended "));
    EXPECT_FALSE(AlertLog("/proc/no/such/alerts.log").write({{AlertChange::What::Raised, {}, at(0)}}));
}

TEST(AlertLogs, KeepTheirSizeWithinALimit) {
    const QTemporaryDir folder;
    const AlertLog log(folder.filePath("alerts.log"));
    QFile file(log.path());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.resize(AlertLog::most_bytes);
    file.close();
    ASSERT_TRUE(log.write({{AlertChange::What::Raised, {}, at(0)}}));
    EXPECT_LT(QFile(log.path()).size(), 1000);
    EXPECT_TRUE(QFile::exists(log.path() + ".1"));
}

}  // namespace
}  // namespace echotrail
