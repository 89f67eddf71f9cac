#include "app/io/pairing_code.hpp"

#include <openssl/crypto.h>

#include <QMessageAuthenticationCode>
#include <QRandomGenerator>
#include <string_view>

namespace echotrail {
namespace {

constexpr std::string_view digits = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";  // Crockford's base 32
constexpr int bits_of_digit = 5, code_bytes = 10, group = 4;
constexpr std::size_t code_digits = code_bytes * 8 / bits_of_digit;

std::optional<unsigned> digitFrom(char c) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (c == 'O') c = '0';
    if (c == 'I' || c == 'L') c = '1';
    const auto found = digits.find(c);
    if (found == std::string_view::npos) return std::nullopt;
    return static_cast<unsigned>(found);
}

}  // namespace

PairingCode PairingCode::make() {
    QByteArray bits;
    for (int i = 0; i < code_bytes; ++i)
        bits += static_cast<char>(QRandomGenerator::system()->bounded(256));  // the kernel's own
    return PairingCode(bits);
}

std::optional<PairingCode> PairingCode::parse(const std::string& text) {
    QByteArray bits;
    std::size_t count = 0;
    unsigned held = 0, held_bits = 0;
    for (const char c : text) {
        if (c == '-' || c == ' ') continue;
        const auto digit = digitFrom(c);
        if (!digit || ++count > code_digits) return std::nullopt;
        held = (held << bits_of_digit | *digit) & 0xFFFF;
        held_bits += bits_of_digit;
        if (held_bits < 8) continue;
        held_bits -= 8;
        bits += static_cast<char>(held >> held_bits & 0xFF);
    }
    if (count != code_digits) return std::nullopt;
    return PairingCode(bits);
}

std::string PairingCode::text() const {
    std::string text;
    unsigned held = 0, held_bits = 0;
    std::size_t count = 0;
    for (const char byte : bits_) {
        held = (held << 8 | static_cast<unsigned char>(byte)) & 0xFFFF;
        for (held_bits += 8; held_bits >= bits_of_digit;) {
            held_bits -= bits_of_digit;
            if (count > 0 && count % group == 0) text += '-';
            text += digits[held >> held_bits & 31];
            ++count;
        }
    }
    return text;
}

QByteArray PairingCode::proof(Prover prover, const QByteArray& tracker_fingerprint,
                              const QByteArray& console_fingerprint) const {
    // The code has as many bits as nobody can try in its time, or later: it needs no stretching.
    const QByteArray who = prover == Prover::Console ? "console\n" : "tracker\n";
    return QMessageAuthenticationCode::hash("echotrail pairing 1\n" + who + tracker_fingerprint + console_fingerprint,
                                            bits_, QCryptographicHash::Sha256);
}

bool isSameProof(const QByteArray& one, const QByteArray& other) {
    return one.size() == other.size() &&
           CRYPTO_memcmp(one.constData(), other.constData(), static_cast<std::size_t>(one.size())) == 0;
}

PairingDesk::Verdict PairingDesk::judge(const QByteArray& proof, const QByteArray& tracker_fingerprint,
                                        const QByteArray& console_fingerprint, Microseconds since_made) {
    if (isOver(since_made)) return Verdict::Over;
    const QByteArray right = code_.proof(PairingCode::Prover::Console, tracker_fingerprint, console_fingerprint);
    if (isSameProof(proof, right)) {
        used_ = true;
        return Verdict::Right;
    }
    --left_;
    return Verdict::Wrong;
}

}  // namespace echotrail
