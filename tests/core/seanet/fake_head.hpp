#pragma once

#include "core/seanet/commands.hpp"
#include "core/seanet/head_data.hpp"
#include "core/seanet/head_session.hpp"
#include "core/seanet/messages.hpp"

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace echotrail::seanet {

/// A head by the letter of the notes, to talk to a session with. It writes down whatever a host must not do.
struct FakeHead {
    using Time = Microseconds;
    bool digital = false, half_duplex = false, alives_stopped = false, centres = true, obeys = true;
    bool keeps_parameters = false;  ///< over a reboot
    Time answer_delay{2'000}, line_time{60'000}, boot{3'000'000};
    int line_repeats = 1;
    int repeats = 1;                 ///< each answer is said so often
    std::set<std::uint8_t> deaf_to;  ///< message ids that it does not answer
    int lose_lines = 0;              ///< so many of the next lines do not arrive
    std::uint8_t line_status = 0x10, node = 2;

    bool powered = true, has_parameters = false;
    HeadCommand command;
    Time boot_until{0}, next_alive{0}, line_at{0};
    int triggers = 0;  ///< running and waiting
    int bearing = 3200;
    std::map<std::uint8_t, int> heard;  ///< message id → frames
    int gains_heard = 0;
    std::vector<std::string> offences;
    std::deque<std::pair<Time, FrameBytes>> out;
    FrameParser parser;

    void powerUp(Time now) {
        powered = true;
        if (!keeps_parameters) has_parameters = false;
        triggers = 0;
        out.clear();
        boot_until = now + boot;
        next_alive = now + Time(1'000'000);
    }
    void say(Time at, std::uint8_t id, const std::vector<std::uint8_t>& payload) {
        for (int i = 0; i < repeats; ++i) out.emplace_back(at, makeFrame(node, 255, id, 0x80, node, payload));
    }
    void take(Time now, const FrameBytes& bytes) {
        if (!powered) return;
        std::size_t frames = 0;
        parser.take(bytes, [&](const Frame& frame) {
            ++frames;
            hear(now, frame);
        });
        if (frames != 1) offences.push_back("not one whole frame");
    }
    void hear(Time now, const Frame& frame) {
        const MessageId id{frame.id()};
        ++heard[frame.id()];
        if (half_duplex && triggers > 0) offences.push_back("spoke out of turn: " + messageName(frame.id()));
        if (deaf_to.contains(frame.id())) return;
        const Time at = now + answer_delay;
        if (id == MessageId::SendVersion) {
            say(at, 1, ByteWriter().u8(digital ? 7 : 0x31).u8(0x11).u16(77).u32(45074).u16(10987).u8(2).bytes());
        } else if (id == MessageId::SendBBUser) {
            sayBlock(at);
        } else if (id == MessageId::ReBoot) {
            powerUp(now);
        } else if (id == MessageId::HeadCommand) {
            obey(frame.payload());
        } else if (id == MessageId::SendData) {
            if (!has_parameters) offences.push_back("triggered without parameters");
            trigger(now);
        } else {
            offences.push_back("must not be sent: " + messageName(frame.id()));
        }
    }
    void sayBlock(Time at) {
        std::vector<std::uint8_t> block(250, 0);
        const auto put = [&](std::size_t wire, std::uint32_t value, int bytes) {
            for (int i = 0; i < bytes; ++i) block[wire - 13 + i] = static_cast<std::uint8_t>(value >> 8 * i);
        };
        put(15, 0x1234, 2);
        if (digital) {
            put(19, 15, 1), put(59, 1, 1), put(89, 650'000, 4), put(93, 750'000, 4);
            put(132, 300'000, 4), put(136, 400'000, 4), put(146, half_duplex, 1), put(147, 1, 1);
        } else {
            put(59, 0xFFFF, 2), put(99, half_duplex, 2), put(101, 325, 2), put(103, 675, 2);
        }
        say(at, 6, block);
        if (!digital) return;
        say(at + Time(5'000), 63, std::vector<std::uint8_t>(66, 0));
        say(at + Time(10'000), 57, std::vector<std::uint8_t>(14, 0));
    }
    void obey(Bytes payload) {
        if (const auto all = decodeHeadCommand(payload)) {
            if (obeys) command = *all;
            has_parameters = true;
        } else if (const auto gains = decodeGains(payload)) {
            ++gains_heard;
            command.gain = gains->gain;
            command.channels = *gains;
        } else {
            offences.push_back("a command that cannot be read");
        }
    }
    void trigger(Time now) {
        if (triggers == 2 || !has_parameters) return;
        const bool idle = triggers == 0;
        if (idle) line_at = now + line_time;
        triggers += idle && !half_duplex ? 2 : 1;
    }
    HeadData line() {
        HeadData line;
        const std::size_t channel = command.head_control & 0x80 ? 1 : 0;
        line.device_type = digital ? 0x11 : 2;
        line.status = line_status;
        line.head_control = command.head_control;
        line.range_scale = command.range_scale;
        line.gain = command.channels ? command.channels->gain[channel] : command.gain[channel];
        line.ad_interval = command.ad_interval;
        line.left_limit = command.left_limit;
        line.right_limit = command.right_limit;
        line.step = command.step;
        line.bearing = static_cast<std::uint16_t>(bearing = (bearing + command.step) % 6400);
        line.data.assign(line.eightBit() ? command.bins : command.bins / 2, 30);
        return line;
    }
    /// What it says up to now.
    std::vector<FrameBytes> speak(Time now) {
        if (!powered) return {};
        if (triggers > 0 && now >= line_at) {
            if (lose_lines > 0)
                --lose_lines;
            else
                out.insert(out.end(), static_cast<std::size_t>(line_repeats), {now, encodeHeadData(line(), node)});
            --triggers;
            line_at = now + line_time;
            next_alive = now + Time(1'000'000);
        }
        if (triggers == 0 && now >= next_alive && !alives_stopped) {
            const bool centred = centres && now >= boot_until;
            const unsigned info = (centred ? 0x0A : 0x0D) | (has_parameters ? 0x80 : 0x40);
            say(now, 4, ByteWriter().u8(digital ? 0x80 : 0).u32(0).u16(3200).u8(info).bytes());
            next_alive = now + Time(1'000'000);
        }
        std::vector<FrameBytes> said;
        while (!out.empty() && out.front().first <= now) {
            said.push_back(std::move(out.front().second));
            out.pop_front();
        }
        return said;
    }
};

/// A session and a head on one wire, and time.
struct Conversation {
    FakeHead head;
    HeadSession session{HeadSettings{}};
    Microseconds now{0};
    bool wire_in = true;  ///< what the head says reaches the session

    explicit Conversation(FakeHead fake = {}) : head(std::move(fake)) { session.linkUp(now); }
    void run(double seconds) {
        const Microseconds end = now + microsecondsFromSeconds(seconds);
        for (; now < end; now += Microseconds(2'000)) {
            for (const FrameBytes& frame : head.speak(now))
                if (wire_in) session.received(now, frame);
            session.tick(now);
            if (session.deadline() && *session.deadline() <= now) head.offences.push_back("a deadline that is past");
            while (const auto frame = session.takeOutput()) head.take(now, *frame);
        }
    }
    int heard(MessageId id) { return head.heard[static_cast<std::uint8_t>(id)]; }
    const HeadStatus& status() const { return session.status(); }
};

}  // namespace echotrail::seanet
