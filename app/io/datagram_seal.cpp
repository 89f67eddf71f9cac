#include "app/io/datagram_seal.hpp"

#include <openssl/evp.h>
#include <openssl/rand.h>

#include <QtEndian>
#include <memory>

namespace echotrail {
namespace {

constexpr qsizetype head_bytes = 16;
constexpr int nonce_bytes = 12, tag_bytes = 16;

using Cipher = std::unique_ptr<EVP_CIPHER_CTX, decltype(&EVP_CIPHER_CTX_free)>;

Cipher cipher() { return {EVP_CIPHER_CTX_new(), &EVP_CIPHER_CTX_free}; }

QByteArray bigEndian(std::uint64_t number) {
    QByteArray bytes(8, Qt::Uninitialized);
    qToBigEndian(number, bytes.data());
    return bytes;
}

QByteArray nonceOf(DatagramSeal::Side side, std::uint64_t number) {
    QByteArray nonce(4, Qt::Uninitialized);
    qToBigEndian(static_cast<std::uint32_t>(side), nonce.data());
    return nonce + bigEndian(number);
}

const unsigned char* bytesOf(const QByteArray& text) {
    return reinterpret_cast<const unsigned char*>(text.constData());
}
unsigned char* bytesOf(QByteArray& text) { return reinterpret_cast<unsigned char*>(text.data()); }

}  // namespace

std::optional<DatagramKey> DatagramKey::make() {
    DatagramKey made{0, QByteArray(static_cast<qsizetype>(bytes), Qt::Uninitialized)};
    if (RAND_bytes(bytesOf(made.key), static_cast<int>(bytes)) != 1) return std::nullopt;
    if (RAND_bytes(reinterpret_cast<unsigned char*>(&made.session), sizeof made.session) != 1) return std::nullopt;
    if (made.session == 0) made.session = 1;  // 0 is none
    return made;
}

QByteArray DatagramSeal::seal(const QByteArray& text) {
    const std::uint64_t number = ++sent_;
    QByteArray datagram = bigEndian(key_.session) + bigEndian(number);
    const QByteArray nonce = nonceOf(own_, number);
    QByteArray hidden(text.size(), Qt::Uninitialized), tag(tag_bytes, Qt::Uninitialized);
    const Cipher context = cipher();
    int length = 0;
    const bool done =
        context &&
        EVP_EncryptInit_ex(context.get(), EVP_aes_256_gcm(), nullptr, bytesOf(key_.key), bytesOf(nonce)) == 1 &&
        EVP_EncryptUpdate(context.get(), nullptr, &length, bytesOf(std::as_const(datagram)), head_bytes) == 1 &&
        EVP_EncryptUpdate(context.get(), bytesOf(hidden), &length, bytesOf(text), static_cast<int>(text.size())) == 1 &&
        EVP_EncryptFinal_ex(context.get(), nullptr, &length) == 1 &&
        EVP_CIPHER_CTX_ctrl(context.get(), EVP_CTRL_GCM_GET_TAG, tag_bytes, tag.data()) == 1;
    return done ? datagram + hidden + tag : QByteArray();
}

std::optional<QByteArray> DatagramSeal::open(const QByteArray& datagram) {
    const qsizetype size = datagram.size() - static_cast<qsizetype>(overhead);
    if (size < 0 || sessionOf(datagram) != key_.session) return std::nullopt;
    const auto number = qFromBigEndian<std::uint64_t>(datagram.constData() + 8);
    const QByteArray nonce = nonceOf(own_ == Side::Tracker ? Side::Console : Side::Tracker, number);
    QByteArray text(size, Qt::Uninitialized), tag = datagram.last(tag_bytes);
    const Cipher context = cipher();
    int length = 0;
    const bool genuine =
        context &&
        EVP_DecryptInit_ex(context.get(), EVP_aes_256_gcm(), nullptr, bytesOf(key_.key), bytesOf(nonce)) == 1 &&
        EVP_DecryptUpdate(context.get(), nullptr, &length, bytesOf(datagram), head_bytes) == 1 &&
        EVP_DecryptUpdate(context.get(), bytesOf(text), &length, bytesOf(datagram) + head_bytes,
                          static_cast<int>(size)) == 1 &&
        EVP_CIPHER_CTX_ctrl(context.get(), EVP_CTRL_GCM_SET_TAG, tag_bytes, tag.data()) == 1 &&
        EVP_DecryptFinal_ex(context.get(), nullptr, &length) == 1;
    if (!genuine || !window_.accept(number)) return std::nullopt;
    return text;
}

std::uint64_t DatagramSeal::sessionOf(const QByteArray& datagram) {
    return datagram.size() < head_bytes ? 0 : qFromBigEndian<std::uint64_t>(datagram.constData());
}

}  // namespace echotrail
