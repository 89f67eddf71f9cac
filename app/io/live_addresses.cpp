#include "app/io/live_addresses.hpp"

#include "app/io/simulated_device.hpp"

namespace echotrail {
namespace {

/// One line of a simulated device of this process: never down, and as slow as the serial line that is simulated.
class SimulatedChannel : public ByteChannel {
public:
    explicit SimulatedChannel(std::shared_ptr<SimulatedDevice> device)
        : ByteChannel(LinkAddress{}), device_(std::move(device)) {}

protected:
    SimulatedDevice& device() { return *device_; }

private:
    void shut() override { device_->disconnect(this); }
    qint64 waitingBytes() const override { return 0; }
    bool write(const QByteArray&) override { return true; }

    std::shared_ptr<SimulatedDevice> device_;
};

class SimulatedSonar final : public SimulatedChannel {
public:
    using SimulatedChannel::SimulatedChannel;

private:
    void tryOpen() override {
        connect(&device(), &SimulatedDevice::sonarSaid, this, [this](const QByteArray& bytes) { take(bytes); });
        device().start();
        linkMade();
    }
    /// Not at once: no answer may come before the question has been sent.
    bool write(const QByteArray& bytes) override {
        return QMetaObject::invokeMethod(
            &device(), [&device = device(), bytes] { device.receive(bytes); }, Qt::QueuedConnection);
    }
};

class SimulatedNavigationLine final : public SimulatedChannel {
public:
    using SimulatedChannel::SimulatedChannel;

private:
    void tryOpen() override {
        connect(&device(), &SimulatedDevice::navigationSaid, this, [this](const QByteArray& lines) { take(lines); });
        linkMade();
    }
};

std::string typed(const std::variant<LinkAddress, SimulationAddress>& address) {
    return std::visit([](const auto& each) { return toText(each); }, address);
}

}  // namespace

std::string LiveAddresses::sonarText() const { return typed(sonar); }

std::string LiveAddresses::navigationText() const {
    return isSimulated() ? typed(sonar) : navigation ? toText(*navigation) : std::string();
}

Result<LiveAddresses> parseLiveAddresses(const std::string& sonar, const std::string& navigation) {
    LiveAddresses addresses;
    if (isSimulationAddress(sonar)) {
        if (!navigation.empty() && navigation != sonar)
            return Error{"navigation: a simulated head brings its own; leave it out"};
        auto simulation = parseSimulationAddress(sonar);
        if (!simulation) return Error{"sonar: " + simulation.error()};
        addresses.sonar = *std::move(simulation);
        return addresses;
    }
    if (isSimulationAddress(navigation))
        return Error{"navigation: a simulation's belongs to its own head; give the head as " + navigation};
    auto link = parseLinkAddress(sonar);
    if (!link) return Error{"sonar: " + link.error()};
    if (link->kind == LinkAddress::Kind::PseudoTerminal)
        return Error{"sonar: a pseudo-terminal is reached by its device, as serial:///dev/pts/3"};
    if (link->kind == LinkAddress::Kind::Tls) return Error{"sonar: no head speaks TLS; say tcp://HOST:PORT"};
    addresses.sonar = *std::move(link);
    auto told = parseLinkOption("navigation", navigation);
    if (!told) return Error{told.error()};
    if (*told && (*told)->kind == LinkAddress::Kind::Tls)
        return Error{"navigation: no such device speaks TLS; say tcp://HOST:PORT"};
    addresses.navigation = *std::move(told);
    return addresses;
}

LiveChannels makeChannels(const LiveAddresses& addresses) {
    if (const auto* link = std::get_if<LinkAddress>(&addresses.sonar))
        return {makeChannel(*link), addresses.navigation ? makeChannel(*addresses.navigation) : nullptr};
    const auto& simulation = std::get<SimulationAddress>(addresses.sonar);
    const SimulatedDevice::Setup setup{findScenario(simulation.scenario).value(), simulation.seed, {}, {}};
    auto device = std::make_shared<SimulatedDevice>(setup);
    return {std::make_unique<SimulatedSonar>(device), std::make_unique<SimulatedNavigationLine>(device)};
}

}  // namespace echotrail
