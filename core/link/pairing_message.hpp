#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// What a tracker and a console say to each other when they are paired (pairing.proto). What comes is not trusted.
namespace echotrail {

inline constexpr std::size_t pairing_proof_bytes = 32;

struct PairRequest {
    std::string proof;  ///< pairing_proof_bytes
    std::string name;   ///< of the console
};

struct PairReply {
    bool done = false;
    std::string reason;  ///< where it was not done
    std::string proof;   ///< pairing_proof_bytes where it was done, else empty
    std::string name;    ///< of the vehicle
};

/// With its frame, as it goes over the wire.
std::string pairFrame(const PairRequest& request);
std::string pairFrame(const PairReply& reply);
/// From a message without its frame; nothing where it cannot be one. Texts are fit to be shown on one line.
std::optional<PairRequest> readPairRequest(std::string_view message);
std::optional<PairReply> readPairReply(std::string_view message);

/// A link's refusal with its frame: what is said to who may not even say hello.
std::string refusalFrame(const std::string& reason);

}  // namespace echotrail
