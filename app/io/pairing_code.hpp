#pragma once

#include "core/base/time.hpp"
#include "core/link/link_limits.hpp"

#include <QByteArray>
#include <optional>
#include <string>

namespace echotrail {

/// A one-time code of 80 random bits, that a person carries from the tracker to the console.
class PairingCode {
public:
    static PairingCode make();
    /// As typed: capitals or not, with or without hyphens and spaces; O is 0, I and L are 1.
    static std::optional<PairingCode> parse(const std::string& text);
    /// Four groups of four, without letters that look like digits.
    std::string text() const;

    enum class Prover { Console, Tracker };
    /// That its prover knows the code, and sees these two certificates and no others (pairing.proto).
    QByteArray proof(Prover prover, const QByteArray& tracker_fingerprint, const QByteArray& console_fingerprint) const;

private:
    explicit PairingCode(const QByteArray& bits) : bits_(bits) {}
    QByteArray bits_;
};

/// Of the same bytes; the time it takes does not tell how many agree.
bool isSameProof(const QByteArray& one, const QByteArray& other);

/// The tracker's side of one code: five wrong tries or five minutes, and it is worth nothing; or one right one.
/// Times are monotonic, from when the code was made.
class PairingDesk {
public:
    enum class Verdict { Right, Wrong, Over };
    explicit PairingDesk(const PairingCode& code) : code_(code) {}

    Verdict judge(const QByteArray& proof, const QByteArray& tracker_fingerprint, const QByteArray& console_fingerprint,
                  Microseconds since_made);
    bool isOver(Microseconds since_made) const {
        return used_ || since_made > link_limits::pairing_lasts || left_ <= 0;
    }
    int triesLeft() const { return left_; }
    const PairingCode& code() const { return code_; }

private:
    PairingCode code_;
    int left_ = link_limits::pairing_tries;
    bool used_ = false;
};

}  // namespace echotrail
