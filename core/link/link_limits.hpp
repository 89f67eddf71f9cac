#pragma once

#include "core/base/time.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>

/// Everything the other side can send, hold or use up has a limit, and stands here.
namespace echotrail::link_limits {

inline constexpr std::uint32_t oldest_version = 1, newest_version = 1;

inline constexpr std::size_t longest_request = 64 * 1024;        ///< bytes, to the tracker
inline constexpr std::size_t longest_message = 4 * 1024 * 1024;  ///< bytes, to a console

// What one console may do
inline constexpr std::size_t most_consoles = 16;
inline constexpr std::size_t longest_name = 64;        ///< bytes, of a console or a program
inline constexpr std::size_t longest_remark = 1000;    ///< bytes
inline constexpr std::size_t most_assignments = 1000;  ///< in one request
inline constexpr std::size_t longest_word = 256;       ///< bytes, of a parameter's name or value
inline constexpr double requests_per_second = 50.0;    ///< on average
inline constexpr double requests_at_once = 100.0;
inline constexpr std::uint32_t most_refusals = 20;        ///< then it is dropped
inline constexpr std::size_t most_waiting_requests = 64;  ///< that the run has not answered, of all consoles
inline constexpr double farthest_pick_m = 10'000.0;
inline constexpr Microseconds hello_within{5'000'000};
inline constexpr Microseconds silence{15'000'000};
inline constexpr Microseconds reads_nothing{10'000'000};  ///< while something waits for it
inline constexpr Microseconds between_snapshots{1'000'000};

// Who may come in
inline constexpr std::size_t most_handshakes = 16;      ///< at once, of TLS
inline constexpr std::size_t most_handshakes_each = 4;  ///< from one address: one alone does not keep all others out
inline constexpr std::chrono::milliseconds handshake_within{5'000};
inline constexpr std::size_t longest_pairing_message = 1024;  ///< bytes
inline constexpr int pairing_tries = 5;                       ///< wrong codes; then the code is worth nothing
inline constexpr std::chrono::milliseconds pairing_lasts{300'000};
inline constexpr std::chrono::milliseconds pairing_answer{10'000};
inline constexpr std::size_t most_paired = 200;  ///< on one machine

// Recordings: what is asked for of them
inline constexpr std::size_t most_record_requests = 4;  ///< of one console, that have no answer yet
inline constexpr std::size_t longest_rows = 64 * 1024;  ///< bytes in one answer, about
inline constexpr std::size_t fewest_rows = 2 * 1024;
inline constexpr double rows_per_second = 2e6;  ///< bytes that are read for all consoles together, on average
inline constexpr Microseconds between_rows_spared{1'000'000};  ///< where the way is too slow for the picture
inline constexpr std::size_t most_recordings = 500;
inline constexpr std::size_t most_parts = 10'000;  ///< of one recording
inline constexpr std::size_t longest_configuration = 256 * 1024;
inline constexpr std::size_t longest_payload = 16 * 1024;  ///< of one row

// Control
inline constexpr Microseconds control_answer{15'000'000};  ///< then who has asked may take it

// What waits for one console, bytes; beyond it see SendQueue
inline constexpr std::size_t urgent_bytes = 6 * 1024 * 1024;  ///< a snapshot must fit
inline constexpr std::size_t regions_bytes = 256 * 1024;
inline constexpr std::size_t particles_bytes = 256 * 1024;
inline constexpr std::size_t picture_bytes = 2 * 1024 * 1024;
inline constexpr std::size_t record_bytes = most_record_requests * 512 * 1024;

// Datagrams
inline constexpr std::size_t longest_datagram_text = 1'168;  ///< bytes before it is sealed: 1200 go uncut on any way
inline constexpr std::size_t most_datagrams = 64;            ///< that wait for one console; then the oldest goes
inline constexpr std::size_t datagram_key_bytes = 32;
inline constexpr Microseconds between_reports{250'000};
inline constexpr Microseconds nothing_arrives{2'000'000};  ///< then the streams go by TCP

// What is kept for those who come late
inline constexpr std::size_t recent_beams = 2000;
inline constexpr std::size_t recent_bytes = 1536 * 1024;
inline constexpr std::size_t recent_regions = 500;
inline constexpr std::size_t recent_log_lines = 50;

// What a console believes
inline constexpr std::size_t most_levels = 8192;
inline constexpr std::size_t most_tracks = 2000, most_looks = 4000, longest_history = 256;
inline constexpr std::size_t most_regions = 1000, most_outline_points = 4000;
inline constexpr std::size_t most_particles = 4096;
inline constexpr std::size_t most_counts = 200;
inline constexpr std::size_t longest_text = 4096;
inline constexpr double farthest_m = 1e7;           ///< of any coordinate
inline constexpr std::size_t most_events = 20'000;  ///< that nobody has taken from a LinkClient

inline constexpr std::size_t particles_sent = 200;  ///< of a track

}  // namespace echotrail::link_limits
