#pragma once

#include "core/base/result.hpp"

#include <QByteArray>
#include <QDateTime>
#include <QSslCertificate>
#include <QSslKey>
#include <QString>
#include <vector>

namespace echotrail {

/// What this machine shows to others: its own, self-signed.
struct OwnCertificate {
    QSslCertificate certificate;
    QSslKey key;
};

/// SHA-256 of a certificate's DER: what is pinned. Empty for no certificate.
QByteArray fingerprintOf(const QSslCertificate& certificate);

/// Whom this machine trusts, and its own certificate: a folder that only its owner may enter, with a file for each that
/// it is paired with. Nothing is kept in memory: what another process pairs or revokes holds at once.
class TrustStore {
public:
    enum class Role { Console, Tracker };  ///< of the other side: a console that is trusted is no tracker
    struct Peer {
        Role role = Role::Console;
        QByteArray fingerprint;
        QString name;
        QDateTime paired;
    };

    explicit TrustStore(const QString& folder) : folder_(folder) {}
    /// `$XDG_DATA_HOME/echotrail/link`.
    static TrustStore ofUser();

    /// Made on first use. The error says what is wrong with the files, and what to do.
    Result<OwnCertificate> own() const;
    bool isPaired(Role role, const QByteArray& fingerprint) const;
    /// The same side paired again gets the new name.
    Result<void> add(const Peer& peer) const;
    /// By name.
    std::vector<Peer> list() const;
    /// By its name, or the beginning of its fingerprint (8 hexadecimal digits or more); gives what is trusted no more.
    /// The error says that nobody, or more than one, is meant.
    Result<Peer> revoke(const QString& name_or_fingerprint) const;

private:
    QString peerPath(Role role, const QByteArray& fingerprint) const;
    Result<void> makeOwn() const;

    QString folder_;
};

}  // namespace echotrail
