#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QWidget>

namespace echotrail {
namespace {

/// What came of one run of echotrail-console.
struct Outcome {
    int exit_code = -1;
    QString errors;
};

Outcome run(const QStringList& arguments, bool with_platform = true, const QString& settings = {}) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (!settings.isEmpty()) environment.insert("XDG_CONFIG_HOME", settings);
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "XDG_RUNTIME_DIR"})
        environment.remove(name);
    if (with_platform) environment.insert("QT_QPA_PLATFORM", "offscreen");
    process.setProcessEnvironment(environment);
    process.start(ECHOTRAIL_CONSOLE, arguments);
    EXPECT_TRUE(process.waitForFinished(120'000)) << "it hangs";
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardError())};
}

class ConsoleProgram : public testing::Test {
protected:
    QByteArray bytesOf(const QString& name) const {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QTemporaryDir folder_;
};

TEST_F(ConsoleProgram, WritesAPictureOfTheDemonstrationAtTheMomentAsked) {
    const QString path = folder_.filePath("night.png");
    const auto outcome = run({"--demonstration", "--screenshot", path, "--at", "8", "--palette", "night"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors.toStdString();
    EXPECT_EQ(QImage(path).size(), QSize(1600, 1000));
}

TEST_F(ConsoleProgram, TheSameCommandGivesTheSamePicture) {
    for (const char* name : {"one.png", "two.png"})
        EXPECT_EQ(
            run({"--demonstration", "--screenshot", folder_.filePath(name), "--at", "5", "--seed", "3"}).exit_code, 0);
    EXPECT_FALSE(bytesOf("one.png").isEmpty());
    EXPECT_EQ(bytesOf("one.png"), bytesOf("two.png"));
}

TEST_F(ConsoleProgram, ShowsTheStartWithoutASource) {
    EXPECT_EQ(run({"--screenshot", folder_.filePath("start.png")}).exit_code, 0);
    EXPECT_FALSE(QImage(folder_.filePath("start.png")).isNull());
}

TEST_F(ConsoleProgram, TakesAPictureOfAHeadThatIsNotThereWithoutKeepingAnything) {
    const auto outcome = run(
        {"--sonar", "tcp://127.0.0.1:1", "--no-record", "--screenshot", folder_.filePath("silent.png"), "--at", "0.5"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors.toStdString();
    EXPECT_EQ(QImage(folder_.filePath("silent.png")).size(), QSize(1600, 1000));
}

TEST_F(ConsoleProgram, WatchesARecordingHeadlessAndTakesPicturesOnTheWay) {
    const auto outcome =
        run({"--headless", "--demonstration", "--target", "40,-25", "--screenshot-to", folder_.filePath("late.png"),
             "--at", "30", "--screenshot-to", folder_.filePath("early.png"), "--at", "6", "--exit-at", "31"},
            false);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors.toStdString();
    const QImage early(folder_.filePath("early.png"));
    const QImage late(folder_.filePath("late.png"));
    EXPECT_EQ(early.size(), QSize(1600, 1000));
    EXPECT_EQ(late.size(), early.size());
    EXPECT_NE(late, early);
}

TEST_F(ConsoleProgram, SaysNothingWithoutADisplayUnlessSomethingIsWrong) {
    const QString path = folder_.filePath("quiet.png");
    const auto outcome = run({"--headless", "--demonstration", "--screenshot-to", path, "--at", "2"}, false);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.errors, "");
    const QString nowhere = folder_.filePath("no/folder.png");
    EXPECT_EQ(run({"--headless", "--screenshot-to", nowhere}, false).errors,
              "echotrail-console: " + nowhere + " could not be written\n");
}

TEST_F(ConsoleProgram, AMomentPastTheEndIsExitCodeThreeWithThePictureOfTheEnd) {
    const auto outcome =
        run({"--headless", "--demonstration", "--screenshot-to", folder_.filePath("end.png"), "--at", "5000"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_TRUE(outcome.errors.contains("past the end")) << outcome.errors.toStdString();
    EXPECT_FALSE(QImage(folder_.filePath("end.png")).isNull());
}

TEST_F(ConsoleProgram, EndsHeadlessAfterThePicturesOrWhenInterrupted) {
    EXPECT_EQ(run({"--headless", "--exit-at", "0.1"}, false).exit_code, 0);
    QProcess process;
    process.start(ECHOTRAIL_CONSOLE, {"--headless", "--sonar", "simulation://demo", "--no-record"});
    ASSERT_TRUE(process.waitForStarted());
    EXPECT_FALSE(process.waitForFinished(2'000)) << "a head is polled until someone ends it";
    process.terminate();
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(process.exitCode(), 0);
}

TEST_F(ConsoleProgram, ClosesWhenToldTo) { EXPECT_EQ(run({"--demonstration", "--quit-after", "0.3"}).exit_code, 0); }

TEST_F(ConsoleProgram, TheWindowComesBackAsLargeAsItWasLeft) {
    const auto open = [&](const QStringList& size) {
        EXPECT_EQ(run(QStringList{"--quit-after", "0.3"} + size, true, folder_.path()).exit_code, 0);
        const QSettings settings(folder_.filePath("echotrail/console.ini"), QSettings::IniFormat);
        QWidget window;
        EXPECT_TRUE(window.restoreGeometry(settings.value("geometry").toByteArray()));
        return window.size();
    };
    EXPECT_EQ(open({"--width", "1350", "--height", "850"}), QSize(1350, 850));
    EXPECT_EQ(open({}), QSize(1350, 850));
    EXPECT_EQ(open({"--width", "1400"}), QSize(1400, 850));
}

TEST_F(ConsoleProgram, WrongUsageIsExitCodeTwoWithOneLine) {
    const QList<QStringList> wrong{{"--set", "sound_speeed=1500"},
                                   {"--set", "sound_speed=9"},
                                   {"--palette", "pink"},
                                   {"--at", "3"},
                                   {"--screenshot-to", "a.png", "--at", "1", "--screenshot-to", "b.png"},
                                   {"--screenshot-to", "a.png", "--show", "kitchen"},
                                   {"--target", "north"},
                                   {"--navigation", "tcp://127.0.0.1:1"},
                                   {"--sonar", "tcp://127.0.0.1:1", "--demonstration"},
                                   {"--connect", "tcp://127.0.0.1:1", "--set", "sound_speed=1500"},
                                   {"--parameters", "/no/such.toml"}};
    for (const QStringList& arguments : wrong) {
        const auto outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments.join(' ').toStdString();
        EXPECT_FALSE(outcome.errors.isEmpty());
    }
    EXPECT_TRUE(run({"--set", "sound_speeed=1500"}).errors.contains("did you mean sound_speed?"));
}

TEST_F(ConsoleProgram, WhatCannotBeReadOrWrittenIsExitCodeOne) {
    const auto unread = run({"/no/such/file.V4LOG", "--screenshot", folder_.filePath("x.png")});
    EXPECT_EQ(unread.exit_code, 1);
    EXPECT_TRUE(unread.errors.contains("file.V4LOG")) << unread.errors.toStdString();
    EXPECT_EQ(run({"--screenshot", "/no/such/folder/x.png"}).exit_code, 1);
    const auto unknown = run({"--sonar", "radio://x", "--screenshot", folder_.filePath("x.png")});
    EXPECT_EQ(unknown.exit_code, 1);
    EXPECT_TRUE(unknown.errors.contains("tcp://HOST:PORT")) << unknown.errors.toStdString();
    const auto dark = run({"--demonstration"}, false);
    EXPECT_EQ(dark.exit_code, 1);
    EXPECT_TRUE(dark.errors.contains("no display")) << dark.errors.toStdString();
}

}  // namespace
}  // namespace echotrail
