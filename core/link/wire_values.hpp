#pragma once

#include "core/link/link.pb.h"
#include "core/link/link_values.hpp"

#include <google/protobuf/repeated_ptr_field.h>

#include <optional>

/// From values to messages and back; only the link's own sources include this. What comes is never trusted: each
/// reader gives nothing for a message that cannot be (not finite, too long, too much, no such enumerator).
namespace echotrail {

std::int64_t microsecondsOf(Timestamp time);
/// Within the years that a message can mean; a time beyond is refused, for arithmetic with it would overflow.
std::optional<Timestamp> timeFrom(std::int64_t us);
std::int64_t optionalMicroseconds(const std::optional<Timestamp>& time);

/// A number of SI units that is finite and no larger than any the link carries.
bool isSane(double value);
/// Fit to be shown on one line, and to be sent: no more than `longest` bytes of whole UTF-8 characters, control
/// characters made spaces, bytes that are no character question marks.
std::string cleanText(std::string_view text, std::size_t longest);
bool parse(std::string_view text, google::protobuf::MessageLite& message);

void write(const NamedValue& value, wire::Parameter& out);
std::optional<NamedValue> read(const wire::Parameter& in);
std::optional<std::vector<NamedValue>> read(const google::protobuf::RepeatedPtrField<wire::Parameter>& in);
void write(const LinkParameters& parameters, wire::Parameters& out);
std::optional<LinkParameters> read(const wire::Parameters& in);
void write(const LinkControl& control, wire::Control& out);
LinkControl read(const wire::Control& in);
void write(const LinkLog& log, wire::Log& out);
std::optional<LinkLog> read(const wire::Log& in);

void write(const Pose& pose, wire::Pose& out);
std::optional<Pose> read(const wire::Pose& in);
/// `detail`: each level the strongest of so many; 0 leaves them out.
void write(const LinkBeam& beam, std::size_t detail, wire::Beam& out);
std::optional<LinkBeam> read(const wire::Beam& in);

void write(const RegionFeatures& features, wire::Features& out);
std::optional<RegionFeatures> read(const wire::Features& in);
void write(const Region& region, wire::Region& out);
std::optional<Region> read(const wire::Region& in);
std::optional<LinkRegions> read(const wire::Regions& in);

void write(const TrackLook& look, wire::Look& out);
std::optional<TrackLook> read(const wire::Look& in);
void write(const Track& track, bool with_history, wire::Track& out);
std::optional<Track> read(const wire::Track& in);
std::optional<LinkTracks> read(const wire::Tracks& in);
/// Every so-manyth of them, no more than `most`, weights adding up to 1 again.
void write(int track, const ParticleCloud& cloud, std::size_t most, wire::Particles::Cloud& out);
std::optional<LinkClouds> read(const wire::Particles& in);

void write(const LinkRecordings& recordings, wire::Recordings& out);
std::optional<LinkRecordings> read(const wire::Recordings& in);
void write(const LinkRecording& recording, wire::Recording& out);
std::optional<LinkRecording> read(const wire::Recording& in);
void write(const LinkRows& rows, wire::Rows& out);
std::optional<LinkRows> read(const wire::Rows& in);
void write(const LinkReadRows& wanted, wire::ReadRows& out);
std::optional<LinkReadRows> read(const wire::ReadRows& in);

void write(const LinkHealth& health, wire::Health& out);
std::optional<LinkHealth> read(const wire::Health& in);

}  // namespace echotrail
