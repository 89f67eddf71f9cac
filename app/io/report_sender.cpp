#include "app/io/report_sender.hpp"

#include <utility>

namespace echotrail {
namespace {

// A few reports of some hundred bytes; more than that waiting means a peer that does not keep up.
constexpr qint64 longest_queue_bytes = 4 * 1024;

}  // namespace

Result<std::unique_ptr<ReportSender>> ReportSender::open(const LinkAddress& address) {
    const bool network = address.kind == LinkAddress::Kind::Tcp || address.kind == LinkAddress::Kind::Udp;
    if (!network || address.port == 0)
        return Error{"reports cannot go to " + toText(address) + "; say udp://HOST:PORT or tcp://HOST:PORT"};
    auto channel = makeChannel(address);
    channel->setLongestQueue(longest_queue_bytes);
    channel->open();
    return std::unique_ptr<ReportSender>(new ReportSender(std::move(channel)));
}

void ReportSender::send(std::string_view line) {
    QByteArray bytes(line.data(), static_cast<qsizetype>(line.size()));
    bytes += '\n';
    ++(channel_->send(bytes) ? counts_.sent : counts_.dropped);
}

}  // namespace echotrail
