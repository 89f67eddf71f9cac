#pragma once

#include <QByteArray>
#include <QElapsedTimer>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace echotrail {

/// What a radio does to TCP, between a console and a tracker: every byte is late, a lost packet holds up all behind it,
/// and no more than so much goes over in a second. It holds little itself, so that the sender feels it.
class SlowWay {
public:
    struct Params {
        int delay_ms = 0;             ///< each way
        int stall_every_ms = 0;       ///< 0: never
        int stall_ms = 0;             ///< for so long nothing goes over
        double bytes_per_second = 0;  ///< each way; 0: any number
    };
    SlowWay(std::uint16_t to_port, const Params& params);
    std::uint16_t port() const { return own_port_; }
    /// As a pulled cable that is noticed.
    void cut() { pairs_.clear(); }
    /// The same, and it stays out until it is plugged in again.
    void unplug();
    void plug();
    std::uint64_t stalls() const { return stalls_; }

private:
    struct Late {
        qint64 due_ms = 0;
        QByteArray bytes;
    };
    struct Direction {
        QTcpSocket *from = nullptr, *to = nullptr;
        std::deque<Late> under_way;
        double may_send = 0.0;
    };
    struct Pair {
        std::unique_ptr<QTcpSocket> console, tracker;
        Direction up, down;
    };
    void take();
    void tick();
    void carry(Direction& direction, double passed_s);
    bool stalled();

    std::uint16_t to_port_;
    Params params_;
    QTcpServer listener_;
    std::uint16_t own_port_ = 0;
    QTimer tick_;
    QElapsedTimer clock_;
    qint64 last_ms_ = 0, stall_until_ms_ = 0, next_stall_ms_ = 0;
    std::uint64_t stalls_ = 0;
    std::vector<std::unique_ptr<Pair>> pairs_;
};

}  // namespace echotrail
