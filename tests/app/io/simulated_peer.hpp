#pragma once

#include "app/io/byte_server.hpp"
#include "core/simulation/simulated_head.hpp"

#include <QObject>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

namespace echotrail {

/// A simulated head on a port of this process; it hears one bright echo half way out, at every bearing or where
/// `object_at` says.
class SimulatedPeer : public QObject {
public:
    using ObjectAt = std::function<bool(const HeadSetup&)>;

    explicit SimulatedPeer(const std::string& address = "tcp://127.0.0.1:0", SimulatedHeadOptions options = quick(),
                           const ObjectAt& object_at = {})
        : server_(ByteServer::listen(parseLinkAddress(address).value()).value()),
          head_(options, [object_at](const HeadSetup& setup, Microseconds, std::uint64_t) {
              return hear(setup, !object_at || object_at(setup));
          }) {
        timer_.setSingleShot(true);
        timer_.setTimerType(Qt::PreciseTimer);
        connect(&timer_, &QTimer::timeout, this, [this] { move(); });
        connect(server_.get(), &ByteServer::received, this, [this](const QByteArray& bytes) {
            head_.received(now(), {reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                   static_cast<std::size_t>(bytes.size())});
            move();
        });
        head_.powerUp(now());
        move();
    }
    std::string address() const { return server_->address(); }
    ByteServer& server() { return *server_; }

    static SimulatedHeadOptions quick() { return {.boot_s = 0.05, .centring_s = 0.1}; }

private:
    static std::vector<std::uint8_t> hear(const HeadSetup& setup, bool object) {
        std::vector<std::uint8_t> levels(static_cast<std::size_t>(setup.bins), 20);
        if (!object) return levels;
        for (std::size_t bin = levels.size() / 2; bin < levels.size() / 2 + 6 && bin < levels.size(); ++bin)
            levels[bin] = 200;
        return levels;
    }
    void move() {
        head_.tick(now());
        for (const TimedBytes& piece : head_.takeOutput(now()))
            server_->send({reinterpret_cast<const char*>(piece.bytes.data()), static_cast<int>(piece.bytes.size())});
        if (const auto next = head_.deadline())
            timer_.start(
                std::max(std::chrono::ceil<std::chrono::milliseconds>(*next - now()), std::chrono::milliseconds(0)));
    }
    Microseconds now() const {
        return std::chrono::duration_cast<Microseconds>(std::chrono::steady_clock::now() - started_);
    }

    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    std::unique_ptr<ByteServer> server_;
    SimulatedHead head_;
    QTimer timer_;
};

}  // namespace echotrail
