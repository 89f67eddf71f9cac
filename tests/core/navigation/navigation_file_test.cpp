#include "core/navigation/navigation_file.hpp"

#include "core/base/random.hpp"
#include "tests/core/navigation/nmea_lines.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace echotrail {
namespace {

class NavigationFileTest : public ::testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(path_); }

    Result<NavigationFile> read(const std::string& content) {
        std::ofstream(path_, std::ios::binary) << content;
        return readNavigationFile(path_);
    }
    /// The pose at a moment the file must cover.
    static Pose poseAt(const NavigationFile& file, std::int64_t after_ms) {
        const auto pose = file.poses.at(Timestamp(std::chrono::milliseconds(first_ms + after_ms)), 10.0);
        EXPECT_TRUE(pose);
        return pose.value_or(Pose{});
    }

    const std::string path_ = ::testing::TempDir() + "navigation_" +
                              ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".nmea";
};

TEST_F(NavigationFileTest, HeadingOnlyStandsAtTheOriginAndSaysSo) {
    const auto file = read(nmeaLine(0, "HEHDT,10.0,T") + nmeaLine(1000, "HEHDT,20.0,T"));
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->mode, "heading only (HDT)");
    EXPECT_EQ(file->used, (std::map<std::string, std::uint64_t>{{"HDT", 2}}));
    EXPECT_TRUE(file->rejected.empty());
    EXPECT_EQ(file->longest_heading_gap_s, 1.0);
    const Pose pose = poseAt(*file, 500);
    EXPECT_NEAR(pose.heading.inDegrees(), 15.0, 1e-9);
    EXPECT_EQ(pose.north_m, 0.0);
    EXPECT_EQ(pose.east_m, 0.0);
}

TEST_F(NavigationFileTest, HeadingTurnsThroughNorthTheShortWay) {
    // The fix at 500 ms makes a sample of its own, so that the reader interpolates and not only the history.
    const auto file = read(nmeaLine(0, "HEHDT,350.0,T") + nmeaLine(0, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") +
                           nmeaLine(500, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") +
                           nmeaLine(1000, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") + nmeaLine(1000, "HEHDT,20.0,T"));
    ASSERT_TRUE(file) << file.error();
    EXPECT_NEAR(poseAt(*file, 500).heading.inDegrees(), 5.0, 1e-9);
}

TEST_F(NavigationFileTest, FixesRunningNorthGiveMetresNorth) {
    // 0.001 minutes of latitude a second at 45 degrees: 1.8522 m/s.
    std::string content;
    for (int s = 0; s <= 10; ++s) {
        const std::string thousandths = s < 10 ? "00" + std::to_string(s) : "010";
        content += nmeaLine(1000 * s, "HEHDT,0.0,T");
        content += nmeaLine(1000 * s, "GPRMC,000000,A,4500." + thousandths + ",N,00700.000,E,3.6,0.0,230510,,");
        content += nmeaLine(1000 * s, "GPVTG,90.0,T,,M,9.9,N,,K,A");
        content += nmeaLine(1000 * s, "SDDPT,12.0,0.0");
    }
    const auto file = read(content);
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->mode, "heading (HDT) and position (RMC)");
    EXPECT_NEAR(poseAt(*file, 10000).north_m, 18.522, 0.001);
    EXPECT_NEAR(poseAt(*file, 4500).north_m, 8.335, 0.001);
    EXPECT_NEAR(poseAt(*file, 10000).east_m, 0.0, 0.001);
    EXPECT_EQ(file->used, (std::map<std::string, std::uint64_t>{{"HDT", 11}, {"RMC", 11}}));
    EXPECT_EQ(file->unused, (std::map<std::string, std::uint64_t>{{"DPT", 11}, {"VTG", 11}}));
}

TEST_F(NavigationFileTest, SpeedIsIntegratedWhereThereIsNoFix) {
    // From rest to 7.2 knots east in 2 s, then steady for 3 s: 3.704 + 11.112 m.
    const auto file = read(nmeaLine(0, "HEHDT,90.0,T") + nmeaLine(0, "GPVTG,,T,,M,0.0,N,,K,A") +
                           nmeaLine(1000, "GPRMC,000000,V,,,,,,,,,") + nmeaLine(2000, "GPVTG,90.0,T,,M,7.2,N,,K,A") +
                           nmeaLine(5000, "GPVTG,90.0,T,,M,7.2,N,,K,A") + nmeaLine(5000, "HEHDT,90.0,T"));
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->mode, "heading (HDT), position reckoned from speed (VTG)");
    EXPECT_NEAR(poseAt(*file, 2000).east_m, 3.704, 1e-9);
    EXPECT_NEAR(poseAt(*file, 5000).east_m, 14.816, 1e-9);
    EXPECT_NEAR(poseAt(*file, 5000).north_m, 0.0, 1e-9);
    EXPECT_EQ(file->longest_position_gap_s, 3.0);
    EXPECT_EQ(file->rejected, (std::map<std::string, std::uint64_t>{{"not_valid", 1}}));
}

TEST_F(NavigationFileTest, SpeedAlongTheVehicleIsTurnedByItsHeading) {
    const auto file =
        read(nmeaLine(0, "HEHDT,90.0,T") + nmeaLine(0, "VDVBW,,,V,3.6,1.8,A") + nmeaLine(2000, "VDVBW,,,V,3.6,1.8,A") +
             nmeaLine(2000, "HEHDT,90.0,T") + nmeaLine(3000, "VDVBW,,,V,3.6,1.8,A"));
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->mode, "heading (HDT), position reckoned from speed (VBW)");
    EXPECT_NEAR(poseAt(*file, 2000).east_m, 3.704, 1e-9);    // ahead is east
    EXPECT_NEAR(poseAt(*file, 2000).north_m, -1.852, 1e-9);  // starboard is south
    EXPECT_EQ(file->unused, (std::map<std::string, std::uint64_t>{{"VBW", 1}}));
}

TEST_F(NavigationFileTest, PosesAreNotExtendedBeyondEitherSeries) {
    const auto file = read(nmeaLine(0, "HEHDT,0.0,T") + nmeaLine(10000, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") +
                           nmeaLine(20000, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") + nmeaLine(30000, "HEHDT,0.0,T"));
    ASSERT_TRUE(file) << file.error();
    const auto covered = [&](std::int64_t after_ms) {
        return file->poses.at(Timestamp(std::chrono::milliseconds(first_ms + after_ms)), 0.3).has_value();
    };
    EXPECT_TRUE(covered(10000));
    EXPECT_TRUE(covered(20000));
    EXPECT_FALSE(covered(0));
    EXPECT_FALSE(covered(30000));
}

TEST_F(NavigationFileTest, TrueHeadingIsPreferredAndMagneticIsSaid) {
    const std::string magnetic = nmeaLine(0, "HCHDG,50.0,,,,") + nmeaLine(100, "HCHDG,50.0,,,,");
    const auto alone = read(magnetic);
    ASSERT_TRUE(alone) << alone.error();
    EXPECT_EQ(alone->mode, "heading only (HDG, magnetic)");
    const auto both = read(magnetic + nmeaLine(0, "HEHDT,55.0,T"));
    ASSERT_TRUE(both) << both.error();
    EXPECT_NEAR(poseAt(*both, 0).heading.inDegrees(), 55.0, 1e-9);
    EXPECT_EQ(both->unused, (std::map<std::string, std::uint64_t>{{"HDG", 2}}));
}

TEST_F(NavigationFileTest, BadLinesAreCountedAndPassedOver) {
    std::string damaged = nmeaLine(100, "HEHDT,12.0,T");
    damaged[damaged.find("12.0")] = '3';
    const auto file =
        read("\r\n" + nmeaLine(0, "HEHDT,10.0,T") + damaged + "$HEHDT,0.2,T*2D\r\n" + nmeaLine(1000, "HEHDT,20.0,T") +
             nmeaLine(900, "HEHDT,90.0,T") + nmeaLine(1000, "HEHDT,90.0,T") + std::string(5000, 'x') + "\n" +
             nmeaLine(2000, "HEHDT,400.0,T") + nmeaLine(2000, "HEHDT,30.0,T").substr(0, 30));
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->used, (std::map<std::string, std::uint64_t>{{"HDT", 2}}));
    EXPECT_EQ(file->rejected, (std::map<std::string, std::uint64_t>{{"bad_checksum", 1},
                                                                    {"bad_field", 1},
                                                                    {"malformed", 1},
                                                                    {"no_checksum", 1},
                                                                    {"no_time", 1},
                                                                    {"out_of_order", 2}}));
    EXPECT_NEAR(poseAt(*file, 500).heading.inDegrees(), 15.0, 1e-9);
}

TEST_F(NavigationFileTest, LastLineNeedsNoLineEnd) {
    const std::string last = nmeaLine(1000, "HEHDT,20.0,T");
    const auto file = read(nmeaLine(0, "HEHDT,10.0,T") + last.substr(0, last.size() - 2));
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->used.at("HDT"), 2U);
}

TEST_F(NavigationFileTest, LineAsLongAsTheBufferIsCountedOnceAndTheNextIsRead) {
    for (std::size_t length = 1020; length <= 1027; ++length) {
        const auto file =
            read(std::string(length, 'x') + "\n" + nmeaLine(0, "HEHDT,10.0,T") + std::string(length, 'x'));
        ASSERT_TRUE(file) << length << ": " << file.error();
        EXPECT_EQ(file->used.at("HDT"), 1U) << length;
        EXPECT_EQ(file->rejected.at("malformed"), 2U) << length;
    }
}

TEST_F(NavigationFileTest, FilesWithoutNavigationSayWhyTheyAreRefused) {
    EXPECT_NE(readNavigationFile(path_ + ".absent").error().find("cannot be opened"), std::string::npos);
    EXPECT_NE(read("").error().find("holds no usable heading"), std::string::npos);
    EXPECT_NE(read("$HEHDT,0.2,T*2D\n").error().find("rejected: no_time 1"), std::string::npos);
    EXPECT_FALSE(readNavigationFile(::testing::TempDir()));
    const auto apart = read(nmeaLine(0, "HEHDT,0.0,T") + nmeaLine(1000, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,") +
                            nmeaLine(2000, "GPGGA,,0000.000,N,00000.000,E,1,,,,,,,,"));
    ASSERT_FALSE(apart);
    EXPECT_NE(apart.error().find("no time in common"), std::string::npos);
}

TEST_F(NavigationFileTest, DamagedFilesAreReadOrRefusedWithoutHarm) {
    std::string sound;
    for (int i = 0; i < 50; ++i)
        sound += nmeaLine(100 * i, "HEHDT,10.0,T") + nmeaLine(100 * i, "GPVTG,9.0,T,,M,1.0,N,,K");
    RandomStream random(2, 0, 0);
    std::uint64_t rejected = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::string content = sound;
        for (int i = 0; i < 30; ++i) content[random.bits() % content.size()] = static_cast<char>(random.bits());
        const auto file = read(content);
        ASSERT_TRUE(file) << file.error();
        for (const auto& [cause, count] : file->rejected) rejected += count;
        EXPECT_NEAR(poseAt(*file, 2000).heading.inDegrees(), 10.0, 1e-9);
    }
    EXPECT_GT(rejected, 200U * 10U);
}

}  // namespace
}  // namespace echotrail
