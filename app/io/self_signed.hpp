#pragma once

#include "core/base/result.hpp"

#include <string>

namespace echotrail {

/// A fresh key (ECDSA, P-256) with a certificate that it has signed itself, both as PEM.
struct KeyPair {
    std::string key, certificate;
};

/// The certificate carries `name`, for people to read only: what counts is its fingerprint. It never ends, as a
/// vehicle's clock may say any year; what ends it is that the other side revokes it.
Result<KeyPair> makeKeyPair(const std::string& name);

}  // namespace echotrail
