#include "app/io/self_signed.hpp"

#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509.h>

#include <array>
#include <memory>

namespace echotrail {
namespace {

template <auto release>
struct Releaser {
    template <class T>
    void operator()(T* owned) const {
        release(owned);
    }
};
using Key = std::unique_ptr<EVP_PKEY, Releaser<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Releaser<X509_free>>;
using Memory = std::unique_ptr<BIO, Releaser<BIO_free>>;

constexpr std::size_t longest_common_name = 64;  // of X.520

bool nameIt(X509* certificate, const std::string& name) {
    X509_NAME* subject = X509_get_subject_name(certificate);
    const std::string common = "echotrail " + name;
    const auto* bytes = reinterpret_cast<const unsigned char*>(common.data());
    const int length = static_cast<int>(std::min(common.size(), longest_common_name));
    return X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC, bytes, length, -1, 0) == 1 &&
           X509_set_issuer_name(certificate, subject) == 1;
}

bool numberIt(X509* certificate) {
    std::array<unsigned char, 8> bytes{};
    if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1) return false;
    std::uint64_t serial = 0;
    for (const unsigned char byte : bytes) serial = serial << 8 | byte;
    return ASN1_INTEGER_set_uint64(X509_get_serialNumber(certificate), serial >> 1 | 1) == 1;
}

bool dateIt(X509* certificate) {
    return ASN1_TIME_set_string_X509(X509_getm_notBefore(certificate), "700101000000Z") == 1 &&
           ASN1_TIME_set_string_X509(X509_getm_notAfter(certificate), "99991231235959Z") == 1;
}

std::string textIn(BIO* memory) {
    char* data = nullptr;
    const long size = BIO_get_mem_data(memory, &data);
    return {data, static_cast<std::size_t>(size)};
}

}  // namespace

Result<KeyPair> makeKeyPair(const std::string& name) {
    const Error failed{"the system's libcrypto cannot make a key"};
    const Key key(EVP_EC_gen("P-256"));
    const Certificate certificate(X509_new());
    if (!key || !certificate) return failed;
    constexpr long version_3 = 2;
    const bool made = X509_set_version(certificate.get(), version_3) == 1 && numberIt(certificate.get()) &&
                      dateIt(certificate.get()) && nameIt(certificate.get(), name) &&
                      X509_set_pubkey(certificate.get(), key.get()) == 1 &&
                      X509_sign(certificate.get(), key.get(), EVP_sha256()) > 0;
    const Memory key_text(BIO_new(BIO_s_mem())), certificate_text(BIO_new(BIO_s_mem()));
    if (!made || !key_text || !certificate_text ||
        PEM_write_bio_PrivateKey(key_text.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1 ||
        PEM_write_bio_X509(certificate_text.get(), certificate.get()) != 1)
        return failed;
    return KeyPair{textIn(key_text.get()), textIn(certificate_text.get())};
}

}  // namespace echotrail
