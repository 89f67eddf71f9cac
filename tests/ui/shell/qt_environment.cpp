#include "qt_environment.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace echotrail::test {
namespace {

/// One application for all tests, without a screen and with settings of its own.
class QtEnvironment : public testing::Environment {
public:
    void SetUp() override {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8() + "/data");
        application_ = std::make_unique<QApplication>(count_, arguments_);
        QApplication::setOrganizationName("echotrail");
        QApplication::setApplicationName("console-test");
        QApplication::setStyle("Fusion");
    }
    void TearDown() override { application_.reset(); }

private:
    int count_ = 1;
    char name_[16] = "ui_shell_test";
    char* arguments_[2] = {name_, nullptr};
    QTemporaryDir folder_;
    std::unique_ptr<QApplication> application_;
};

const auto* const environment = testing::AddGlobalTestEnvironment(new QtEnvironment);

}  // namespace

bool await(const std::function<bool()>& done) {
    QElapsedTimer clock;
    clock.start();
    while (!done()) {
        if (clock.elapsed() > 60'000) return false;
        QTest::qWait(2);
    }
    return true;
}

}  // namespace echotrail::test
