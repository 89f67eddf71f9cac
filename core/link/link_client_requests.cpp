#include "core/link/link_client.hpp"
#include "core/link/wire_values.hpp"

// What a console asks of a tracker. Each request is named by a number, and answered by it.
namespace echotrail {

std::uint32_t LinkClient::setParameters(const std::vector<NamedValue>& values) {
    wire::ToTracker message;
    message.mutable_set_parameters()->set_base_revision(status_.parameters.revision);
    for (const NamedValue& value : values) write(value, *message.mutable_set_parameters()->add_parameters());
    return ask(message);
}

std::uint32_t LinkClient::designate(double range_m, Bearing from_bow) {
    wire::ToTracker message;
    message.mutable_designate()->set_range_m(range_m);
    message.mutable_designate()->set_bearing_rad(from_bow.inRadians());
    return ask(message);
}

std::uint32_t LinkClient::clearDesignation() {
    wire::ToTracker message;
    message.mutable_clear_designation();
    return ask(message);
}

std::uint32_t LinkClient::drop(int track, double range_m, Bearing from_bow) {
    wire::ToTracker message;
    message.mutable_drop_track()->set_track(static_cast<std::uint32_t>(track));
    message.mutable_drop_track()->set_range_m(range_m);
    message.mutable_drop_track()->set_bearing_rad(from_bow.inRadians());
    return ask(message);
}

std::uint32_t LinkClient::restore(int track) {
    wire::ToTracker message;
    message.mutable_restore_track()->set_track(static_cast<std::uint32_t>(track));
    return ask(message);
}

std::uint32_t LinkClient::annotate(const std::string& text) {
    wire::ToTracker message;
    message.mutable_annotate()->set_text(cleanText(text, link_limits::longest_remark));
    return ask(message);
}

std::uint32_t LinkClient::control(ControlAction action) {
    wire::ToTracker message;
    message.mutable_control()->set_action(static_cast<wire::ControlRequest::Action>(action));
    return ask(message);
}

std::uint32_t LinkClient::listRecordings() {
    wire::ToTracker message;
    message.mutable_list_recordings();
    return ask(message);
}

std::uint32_t LinkClient::describeRecording(const std::string& name) {
    wire::ToTracker message;
    message.mutable_describe_recording()->set_recording(name);
    return ask(message);
}

std::uint32_t LinkClient::readRows(const LinkReadRows& wanted) {
    wire::ToTracker message;
    write(wanted, *message.mutable_read_rows());
    return ask(message);
}

}  // namespace echotrail
