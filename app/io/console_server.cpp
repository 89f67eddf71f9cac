#include "app/io/console_server.hpp"

#include "core/link/pairing_message.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <QHostAddress>
#include <QSslSocket>
#include <QTcpSocket>
#include <QUdpSocket>
#include <utility>

namespace echotrail {
namespace {

// What is in a socket cannot be taken back: little, so that a slow way is noticed and less is sent.
constexpr qint64 socket_bytes = 16 * 1024;
constexpr int kernel_bytes = 128 * 1024;  // what is under way on a far, fast one
constexpr int unsent_bytes = 8 * 1024;    // that the kernel has taken and not yet sent
constexpr qint64 read_bytes = 256 * 1024;
constexpr qint64 read_at_once = 64 * 1024;
constexpr int tick_ms = 50;
constexpr Microseconds last_words{1'000'000};  // for the refusal to go out
constexpr Microseconds notes_interval{10'000'000};
constexpr std::uint64_t notes_per_interval = 20;
constexpr Microseconds trust_interval{1'000'000};

QHostAddress hostOf(const LinkAddress& address) {
    if (address.host == "localhost") return QHostAddress(QHostAddress::LocalHost);
    return QHostAddress(QString::fromStdString(address.host));
}

/// Bytes that the system has not taken.
qint64 waitingIn(const QTcpSocket& socket) {
    const auto* tls = qobject_cast<const QSslSocket*>(&socket);
    return socket.bytesToWrite() + (tls ? tls->encryptedBytesToWrite() : 0);
}

}  // namespace

Result<void> checkServable(const LinkAddress& address) {
    if (address.kind != LinkAddress::Kind::Tcp && address.kind != LinkAddress::Kind::Tls)
        return Error{"consoles are served by TCP or TLS, as in tcp://127.0.0.1:7000 or tls://0.0.0.0:7000"};
    if (hostOf(address).isNull())
        return Error{"'" + address.host + "' is no address of this machine in numbers; 0.0.0.0 is all it has"};
    if (address.kind == LinkAddress::Kind::Tcp && !hostOf(address).isLoopback())
        return Error{"'" + address.host +
                     "' is not this machine's own loopback address (127.0.0.1, ::1 or localhost): whoever could reach "
                     "another one by plain TCP could command the head. Say tls://" +
                     address.host + ":" + std::to_string(address.port) + ", and pair the console with echotrail pair"};
    return {};
}

ConsoleServer::ConsoleServer(const LinkIdentity& identity, std::vector<NamedValue> parameters, Clock clock,
                             Handler handler, const TrustStore& trust)
    : clock_(std::move(clock)),
      handler_(std::move(handler)),
      server_(identity, static_cast<std::uint64_t>(clock_().time_since_epoch().count()), std::move(parameters)),
      trust_(trust) {}

ConsoleServer::~ConsoleServer() {
    datagrams_.reset();
    for (auto& [console, peer] : peers_) {
        peer.socket->disconnect(this);
        peer.socket->abort();
    }
}

void ConsoleServer::serveRecordings(RecordHandler handler) {
    record_handler_ = std::move(handler);
    server_.serveRecordings();
}

Result<LinkAddress> ConsoleServer::listen(const LinkAddress& address) {
    if (auto servable = checkServable(address); !servable) return Error{servable.error()};
    if (auto made = makeListener(address); !made) return Error{made.error()};
    if (!listener_->listen(hostOf(address), address.port))
        return Error{"cannot serve consoles on " + toText(address) + ": " + listener_->errorString().toStdString()};
    if (wants_datagrams_) openDatagrams();
    tick_ = new QTimer(this);
    connect(tick_, &QTimer::timeout, this, [this] { tick(); });
    tick_->start(tick_ms);
    LinkAddress real = address;
    real.port = listener_->serverPort();
    return real;
}

Result<void> ConsoleServer::makeListener(const LinkAddress& address) {
    tls_ = nullptr;
    if (address.kind == LinkAddress::Kind::Tls) {
        const auto own = trust_.own();
        if (!own) return Error{own.error()};
        const auto refusal = refusalFrame(
            "this console is not paired here; run 'echotrail pair' aboard, and 'echotrail "
            "pair tls://HOST:PORT' there with the code that it shows");
        auto tls = std::make_unique<TlsListener>(
            *own, [this](const QByteArray& shown) { return trust_.isPaired(TrustStore::Role::Console, shown); },
            QByteArray::fromStdString(refusal));
        connect(tls.get(), &TlsListener::admitted, this, &ConsoleServer::welcomeByTls);
        connect(tls.get(), &TlsListener::turnedAway, this, &ConsoleServer::tell);
        tls_ = tls.get();
        listener_ = std::move(tls);
        return {};
    }
    listener_ = std::make_unique<QTcpServer>();
    connect(listener_.get(), &QTcpServer::newConnection, this, [this] {
        while (QTcpSocket* socket = listener_->nextPendingConnection()) welcome(socket);
    });
    return {};
}

void ConsoleServer::welcomeByTls(QSslSocket* socket) {
    const QByteArray fingerprint = fingerprintOf(socket->peerCertificate());
    const auto console = welcome(socket);
    if (!console) return;
    // What TLS has taken lies in a buffer of its own until the system takes it.
    connect(socket, &QSslSocket::encryptedBytesWritten, this, [this, id = *console] { flush(id); });
    if (const auto peer = peers_.find(*console); peer != peers_.end()) peer->second.fingerprint = fingerprint;
}

/// A console's number, where there is room for it.
std::optional<std::uint32_t> ConsoleServer::welcome(QTcpSocket* socket) {
    auto key = datagrams_ ? DatagramKey::make() : std::nullopt;
    std::optional<LinkDatagrams> offer;
    if (key) offer = LinkDatagrams{datagrams_->localPort(), key->session, key->key.toStdString()};
    const auto console = server_.connected(clock_(), std::move(offer));
    if (!console) {
        socket->abort();
        socket->deleteLater();
        return console;
    }
    Peer& peer = peers_[*console];
    peer.socket = socket;
    if (key) {
        consoles_of_datagrams_[key->session] = *console;
        peer.seal = std::make_unique<DatagramSeal>(*std::move(key), DatagramSeal::Side::Tracker);
    }
    socket->setReadBufferSize(read_bytes);
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kernel_bytes);
    ::setsockopt(static_cast<int>(socket->socketDescriptor()), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent_bytes,
                 sizeof unsent_bytes);
    connect(socket, &QTcpSocket::readyRead, this, [this, id = *console] { read(id); });
    connect(socket, &QTcpSocket::bytesWritten, this, [this, id = *console] { flush(id); });
    connect(socket, &QTcpSocket::disconnected, this, [this, id = *console] { close(id); });
    if (socket->bytesAvailable() > 0) read(*console);
    return console;
}

void ConsoleServer::read(std::uint32_t console) {
    const auto peer = peers_.find(console);
    if (peer == peers_.end()) return;
    QTcpSocket* socket = peer->second.socket;
    // A little of each in turn: who sends without end does not keep the others waiting.
    const QByteArray bytes = socket->read(read_at_once);
    server_.received(console, clock_(),
                     {reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<std::size_t>(bytes.size())});
    answerRequests();
    answerRecordRequests();
    flush(console);
    tellNotes();
    if (peers_.contains(console) && socket->bytesAvailable() > 0)
        QMetaObject::invokeMethod(
            this, [this, console] { read(console); }, Qt::QueuedConnection);
}

void ConsoleServer::answerRequests() {
    bool answered = false;
    while (const auto request = server_.nextRequest(clock_())) {
        const auto done = handler_(*request);
        if (done && *done) server_.publishParameters(**done, clock_());
        server_.answer(*request, done ? Result<void>() : Result<void>(Error{done.error()}), clock_());
        answered = true;
    }
    if (answered) flush();
}

void ConsoleServer::answerRecordRequests() {
    while (const auto request = server_.nextRecordRequest(clock_())) {
        server_.answer(*request, record_handler_(*request), clock_());
        flush(request->console);
    }
}

void ConsoleServer::flush(std::uint32_t console) {
    const auto found = peers_.find(console);
    if (found == peers_.end()) return;
    Peer& peer = found->second;
    sendDatagrams(console, peer);
    if (const qint64 room = socket_bytes - waitingIn(*peer.socket); room > 0) {
        std::string out;
        server_.takeOutput(console, clock_(), out, static_cast<std::size_t>(room));
        if (!out.empty()) peer.socket->write(out.data(), static_cast<qint64>(out.size()));
    }
    if (!server_.isClosing(console)) return;
    if (!peer.closing_since) {
        peer.closing_since = clock_();
        peer.socket->disconnectFromHost();  // once all is written; the tick does not wait for ever
    }
}

void ConsoleServer::flush() {
    for (auto peer = peers_.begin(); peer != peers_.end();) {
        const std::uint32_t console = (peer++)->first;  // flushing may end it
        flush(console);
    }
}

void ConsoleServer::close(std::uint32_t console) {
    const auto peer = peers_.find(console);
    if (peer == peers_.end()) return;
    QTcpSocket* socket = peer->second.socket;
    std::erase_if(consoles_of_datagrams_, [&](const auto& each) { return each.second == console; });
    peers_.erase(peer);
    socket->disconnect(this);
    socket->abort();
    socket->deleteLater();
    server_.disconnected(console, clock_());
    tellNotes();
}

void ConsoleServer::tick() {
    server_.tick(clock_());
    dropRevoked();
    answerRecordRequests();
    flush();
    std::vector<std::uint32_t> over;
    for (const auto& [console, peer] : peers_)
        if (peer.closing_since && clock_() - *peer.closing_since > last_words) over.push_back(console);
    for (const std::uint32_t console : over) close(console);
    tellNotes();
}

void ConsoleServer::dropRevoked() {
    if (!tls_ || clock_() - trust_checked_ < trust_interval) return;
    trust_checked_ = clock_();
    std::vector<std::uint32_t> revoked;
    for (const auto& [console, peer] : peers_)
        if (!trust_.isPaired(TrustStore::Role::Console, peer.fingerprint)) revoked.push_back(console);
    for (const std::uint32_t console : revoked) {
        tell(tr("a console's pairing has been revoked; it is dropped"));
        close(console);
    }
}

void ConsoleServer::beginNotes() {
    const Timestamp now = clock_();
    if (now - notes_since_ <= notes_interval) return;
    if (notes_untold_ > 0) Q_EMIT noted(tr("%1 more lines about consoles left out").arg(notes_untold_));
    notes_since_ = now;
    notes_left_ = notes_per_interval;
    notes_untold_ = 0;
}

/// No more than so many in a while: nobody fills the tracker's own output by knocking.
void ConsoleServer::tell(const QString& note) {
    beginNotes();
    if (notes_left_ == 0) {
        ++notes_untold_;
        return;
    }
    --notes_left_;
    Q_EMIT noted(note);
}

void ConsoleServer::tellNotes() {
    beginNotes();
    while (const auto note = server_.nextNote()) tell(QString::fromStdString(*note));
}

std::map<std::string, std::uint64_t> ConsoleServer::turnedAway() const {
    if (!tls_) return {};
    return tls_->refused();
}

void ConsoleServer::publish(LinkMoment moment) { server_.publish(std::move(moment), clock_()); }
void ConsoleServer::publish(const LinkHealth& health) { server_.publish(health, clock_()); }
void ConsoleServer::publish(const LinkLog& line) { server_.publish(line, clock_()); }

}  // namespace echotrail
