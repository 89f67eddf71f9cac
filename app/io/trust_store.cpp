#include "app/io/trust_store.hpp"

#include "app/io/self_signed.hpp"
#include "core/link/link_limits.hpp"

#include <unistd.h>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTemporaryFile>
#include <algorithm>
#include <cstdio>
#include <optional>

namespace echotrail {
namespace {

constexpr QFile::Permissions owner_only = QFile::ReadOwner | QFile::WriteOwner;
constexpr QFile::Permissions owner_folder = owner_only | QFile::ExeOwner;
constexpr QFile::Permissions others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
constexpr qsizetype fingerprint_bytes = 32, shortest_beginning = 8;
constexpr qint64 longest_file = 16 * 1024;

QString roleText(TrustStore::Role role) { return role == TrustStore::Role::Console ? "console" : "tracker"; }

/// No moment in which others could read it, and no half a file under its name. What is there already stays, or is
/// replaced.
Result<void> writePrivate(const QString& path, const QByteArray& content, bool replace) {
    QTemporaryFile file(path + ".XXXXXX");  // is made for its owner only
    const bool written =
        file.open() && file.setPermissions(owner_only) && file.write(content) == content.size() && file.flush();
    const QByteArray from = QFile::encodeName(file.fileName()), to = QFile::encodeName(path);
    if (!written || (replace ? std::rename(from, to) : ::link(from, to)) != 0)
        return Error{path.toStdString() + " cannot be written"};
    if (replace) file.setAutoRemove(false);
    return {};
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(longest_file) : QByteArray();
}

/// Nothing for a file that is none of ours, or was damaged.
std::optional<TrustStore::Peer> readPeer(const QString& folder, const QString& file) {
    TrustStore::Peer peer;
    const QString stem = file.chopped(QStringLiteral(".json").size());
    peer.role = stem.startsWith("tracker-") ? TrustStore::Role::Tracker : TrustStore::Role::Console;
    peer.fingerprint = QByteArray::fromHex(stem.mid(stem.indexOf('-') + 1).toLatin1());
    if (peer.fingerprint.size() != fingerprint_bytes || !stem.startsWith(roleText(peer.role) + "-"))
        return std::nullopt;
    const QJsonObject content = QJsonDocument::fromJson(contentOf(folder + "/" + file)).object();
    peer.name = content["name"].toString();
    peer.paired = QDateTime::fromString(content["paired"].toString(), Qt::ISODate);
    return peer;
}

}  // namespace

QByteArray fingerprintOf(const QSslCertificate& certificate) {
    return certificate.isNull() ? QByteArray() : certificate.digest(QCryptographicHash::Sha256);
}

TrustStore TrustStore::ofUser() {
    return TrustStore(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/echotrail/link");
}

Result<void> TrustStore::makeOwn() const {
    auto pair = makeKeyPair(QSysInfo::machineHostName().toStdString());
    if (!pair) return Error{pair.error()};
    // One file: a key never stands beside another's certificate.
    return writePrivate(folder_ + "/own.pem", QByteArray::fromStdString(pair->key + pair->certificate), false);
}

Result<OwnCertificate> TrustStore::own() const {
    const QString path = folder_ + "/own.pem";
    if (!QDir().mkpath(folder_ + "/paired") || !QFile::setPermissions(folder_, owner_folder))
        return Error{"the folder " + folder_.toStdString() + " cannot be made, or belongs to somebody else"};
    if (!QFile::exists(path))
        if (auto made = makeOwn(); !made && !QFile::exists(path)) return Error{made.error()};  // not by another, either
    if (QFile::permissions(path) & others)
        return Error{"others may read the key in " + path.toStdString() +
                     "; remove the file, and pair anew with every other side"};
    const QByteArray text = contentOf(path);
    const OwnCertificate own{QSslCertificate(text, QSsl::Pem), QSslKey(text, QSsl::Ec, QSsl::Pem)};
    if (own.certificate.isNull() || own.key.isNull())
        return Error{path.toStdString() +
                     " holds no key and certificate; remove it, and pair anew with every other side"};
    return own;
}

QString TrustStore::peerPath(Role role, const QByteArray& fingerprint) const {
    return folder_ + "/paired/" + roleText(role) + "-" + QString::fromLatin1(fingerprint.toHex()) + ".json";
}

bool TrustStore::isPaired(Role role, const QByteArray& fingerprint) const {
    return fingerprint.size() == fingerprint_bytes && QFile::exists(peerPath(role, fingerprint));
}

Result<void> TrustStore::add(const Peer& peer) const {
    if (peer.fingerprint.size() != fingerprint_bytes) return Error{"what has no certificate cannot be paired"};
    if (!isPaired(peer.role, peer.fingerprint) && list().size() >= link_limits::most_paired)
        return Error{"too many are paired; revoke some with echotrail pair --revoke NAME"};
    if (!QDir().mkpath(folder_ + "/paired")) return Error{"the folder " + folder_.toStdString() + " cannot be made"};
    const QJsonObject content{{"name", peer.name}, {"paired", peer.paired.toUTC().toString(Qt::ISODate)}};
    return writePrivate(peerPath(peer.role, peer.fingerprint), QJsonDocument(content).toJson(), true);
}

std::vector<TrustStore::Peer> TrustStore::list() const {
    std::vector<Peer> peers;
    const QString folder = folder_ + "/paired";
    for (const QString& file : QDir(folder).entryList({"*.json"}, QDir::Files))
        if (auto peer = readPeer(folder, file)) peers.push_back(*std::move(peer));
    std::sort(peers.begin(), peers.end(), [](const Peer& a, const Peer& b) { return a.name < b.name; });
    return peers;
}

Result<TrustStore::Peer> TrustStore::revoke(const QString& name_or_fingerprint) const {
    std::vector<Peer> meant;
    const QByteArray beginning = name_or_fingerprint.toLatin1().toLower();
    for (const Peer& peer : list())
        if (peer.name == name_or_fingerprint ||
            (beginning.size() >= shortest_beginning && peer.fingerprint.toHex().startsWith(beginning)))
            meant.push_back(peer);
    const std::string typed = "'" + name_or_fingerprint.toStdString() + "'";
    if (meant.empty())
        return Error{"nobody is paired by the name or fingerprint " + typed + "; see echotrail pair --list"};
    if (meant.size() > 1)
        return Error{typed + " names more than one; give the fingerprint that echotrail pair --list shows"};
    if (!QFile::remove(peerPath(meant[0].role, meant[0].fingerprint)))
        return Error{typed + " could not be removed from " + folder_.toStdString()};
    return meant[0];
}

}  // namespace echotrail
