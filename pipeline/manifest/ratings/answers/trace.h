#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

// The answer of a continuous trial: a trace, which holds the position of a marker, 0 to 100 from
// the left, while a film played. Sample k is the position at k / trace_rate_hz seconds of the
// film's own time (the last one: at its end), so that a film that stops for a while has no more
// samples than another. As text, the samples are separated by spaces ("50 50 52.5").

inline constexpr double trace_rate_hz = 10.0;

/// Longest film that can be rated continuously, seconds: its trace and a comment fit into one
/// message to a server.
inline constexpr double longest_trace_seconds = 600.0;

/// Number of samples of a film's trace: ⌈seconds · trace_rate_hz⌉ + 1. The last one is the position
/// at the end of the film, which is less than one sampling interval before its time.
std::size_t trace_samples(double seconds);

/// The time of a sample in a film of that duration, seconds: k / trace_rate_hz, but not later than
/// the end of the film. A film of 0 s is one of unknown duration.
double sample_time(std::size_t sample, double film_seconds);

/// Longest text of a trace of longest_trace_seconds, characters.
std::size_t longest_trace_text();

/// Reads a trace. Nullopt unless it consists of numbers from 0 to 100 with at most one decimal,
/// separated by single spaces.
std::optional<std::vector<double>> read_trace(std::string_view text);

/// Writes a trace. Samples are rounded to one decimal.
std::string to_text(const std::vector<double>& trace);

/// Mean of the samples from `lead` seconds of the film on, if the trace lags `lag` seconds behind
/// the film: sample k is about time k / trace_rate_hz − lag. Nullopt if there are none.
std::optional<double> mean_of_trace(const std::vector<double>& trace, double lead,
                                    double lag = 0.0);

/// Index of the first sample that is about this time or a later one, in seconds of the film: the
/// number of samples before it. May be greater than the size of a trace.
std::size_t first_sample_from(double seconds);

}  // namespace mien::pipeline
