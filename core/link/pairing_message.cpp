#include "core/link/pairing_message.hpp"

#include "core/link/framing.hpp"
#include "core/link/link_limits.hpp"
#include "core/link/pairing.pb.h"
#include "core/link/wire_values.hpp"

namespace echotrail {

std::string pairFrame(const PairRequest& request) {
    wire::PairRequest out;
    out.set_proof(request.proof);
    out.set_name(cleanText(request.name, link_limits::longest_name));
    return linkFrame(out.SerializeAsString());
}

std::string pairFrame(const PairReply& reply) {
    wire::PairReply out;
    out.set_done(reply.done);
    out.set_reason(cleanText(reply.reason, link_limits::longest_text));
    out.set_proof(reply.proof);
    out.set_name(cleanText(reply.name, link_limits::longest_name));
    return linkFrame(out.SerializeAsString());
}

std::optional<PairRequest> readPairRequest(std::string_view message) {
    wire::PairRequest in;
    if (!parse(message, in) || in.proof().size() != pairing_proof_bytes) return std::nullopt;
    return PairRequest{in.proof(), cleanText(in.name(), link_limits::longest_name)};
}

std::optional<PairReply> readPairReply(std::string_view message) {
    wire::PairReply in;
    if (!parse(message, in) || (in.done() && in.proof().size() != pairing_proof_bytes)) return std::nullopt;
    return PairReply{in.done(), cleanText(in.reason(), link_limits::longest_text), in.proof(),
                     cleanText(in.name(), link_limits::longest_name)};
}

std::string refusalFrame(const std::string& reason) {
    wire::ToConsole out;
    out.mutable_refusal()->set_reason(cleanText(reason, link_limits::longest_text));
    return linkFrame(out.SerializeAsString());
}

}  // namespace echotrail
