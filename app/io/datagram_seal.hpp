#pragma once

#include "core/link/replay_window.hpp"

#include <QByteArray>
#include <array>
#include <cstdint>
#include <optional>

namespace echotrail {

/// The key of one console's datagrams, made by the tracker and told by TLS, and the number by which they are known.
struct DatagramKey {
    static constexpr std::size_t bytes = 32;
    std::uint64_t session = 0;
    QByteArray key;

    /// Random, by libcrypto; nothing where that fails.
    static std::optional<DatagramKey> make();
};

/// Datagrams in one connection, sealed by AES-256-GCM (NIST SP 800-38D) with libcrypto: session (8 bytes, the highest
/// first), number (the same), the text enciphered, tag (16). Session and number are authenticated with it; the nonce is
/// who sends (4 bytes) and the number, so that none is used twice under a key.
class DatagramSeal {
public:
    enum class Side : std::uint32_t { Tracker = 1, Console = 2 };
    static constexpr std::size_t overhead = 8 + 8 + 16;
    static constexpr std::size_t longest = 1'200;  ///< bytes of a datagram that no way has to cut in pieces

    DatagramSeal(DatagramKey key, Side own) : key_(std::move(key)), own_(own) {}

    QByteArray seal(const QByteArray& text);
    /// The text, of the other side and for the first time; nothing for any other datagram.
    std::optional<QByteArray> open(const QByteArray& datagram);

    /// Whose it says it is; nothing is believed by that. 0 where it is too short to be one.
    static std::uint64_t sessionOf(const QByteArray& datagram);
    /// Highest number of those that were opened; 0: none.
    std::uint64_t newest() const { return window_.newest(); }

private:
    DatagramKey key_;
    Side own_;
    std::uint64_t sent_ = 0;
    ReplayWindow window_;
};

}  // namespace echotrail
