#include "tests/app/io/event_loop.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <optional>

namespace echotrail {
namespace {

class Application : public testing::Environment {
public:
    void SetUp() override { application_.emplace(count_, &name_); }
    void TearDown() override { application_.reset(); }

private:
    std::string text_ = "app_io_test";
    char* name_ = text_.data();
    int count_ = 1;
    std::optional<QCoreApplication> application_;
};

[[maybe_unused]] const auto* const application = testing::AddGlobalTestEnvironment(new Application);

}  // namespace

bool becomes(const std::function<bool()>& condition) {
    const QDeadlineTimer limit(60'000);
    while (!condition()) {
        if (limit.hasExpired()) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

Listener::Listener(const std::string& address) : server(ByteServer::listen(parseLinkAddress(address).value()).value()) {
    QObject::connect(server.get(), &ByteServer::received, [this](const QByteArray& bytes) { heard += bytes; });
    QObject::connect(server.get(), &ByteServer::peerUp, [this] { ++ups; });
    QObject::connect(server.get(), &ByteServer::peerDown, [this] { ++downs; });
}

Caller::Caller(const std::string& address) : channel(makeChannel(parseLinkAddress(address).value())) {
    QObject::connect(channel.get(), &ByteChannel::received, [this](const QByteArray& bytes) { heard += bytes; });
    QObject::connect(channel.get(), &ByteChannel::wentDown, [this](const QString& reason) { reasons += reason; });
    channel->open();
}

QByteArray everyByte() {
    QByteArray bytes;
    for (int value = 0; value < 256; ++value) bytes += static_cast<char>(value);
    return bytes;
}

}  // namespace echotrail
