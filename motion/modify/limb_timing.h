#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// A part of the body that is retimed as a whole: the timing of all its joints changes alike.
enum class Limb { head, left_hand, right_hand, left_foot, right_foot };

inline constexpr std::array<Limb, 5> all_limbs = {Limb::head, Limb::left_hand, Limb::right_hand,
                                                  Limb::left_foot, Limb::right_foot};

bool has(const Limbs& limbs, Limb limb);

/// Joints of a limb from proximal to distal. The trunk belongs to no limb and keeps the timing of
/// the hips.
std::vector<BodyJoint> joints_of(Limb limb);

/// The end joint, whose speed represents the limb's: head, wrist or ankle.
BodyJoint end_of(Limb limb);

/// Speed of the limb's end relative to the hips in each interval between frames, m/s, low-pass
/// filtered at 12.5 Hz (at 0.3 of the frame rate if that is lower). A loop has as many intervals as
/// frames, any other clip one less.
std::vector<double> limb_speeds(const Clip& clip, Limb limb);

/// Durations of the intervals, in frames, at which the end's speed is constant: the interval's
/// speed divided by the mean speed, but at least 0.05. Intervals in a pause (slower than 0.05 m/s
/// or a tenth of the top speed) keep the duration 1.
std::vector<double> constant_speed_durations(std::span<const double> speeds);

/// Factor by which a pause is stretched at full acceleration. The emotion thesis uses 10, which
/// makes the remaining part of a segment (0.9 s) 2.5 times as fast and looks jerky at 30 frames per
/// second.
inline constexpr double max_pause_factor = 5.5;

/// Relative durations of all intervals, by which the end becomes even slower where it is slow. The
/// intervals are divided into groups of about 0.15 s each (at least 3 intervals). A group that is
/// slower than both its neighbours lasts `pause_factor` times as long. All other intervals have the
/// duration 1, and so do those of groups that never exceed 0.05 m/s: there the end stands still.
std::vector<double> accelerated_durations(std::span<const double> speeds, double frames_per_second,
                                          bool loops, double pause_factor = max_pause_factor);

/// Durations restricted to the neighbourhood of given frames: full effect within 0.1 s, none
/// (duration 1) beyond 0.2 s.
std::vector<double> near_only(std::span<const double> durations, std::span<const int> moments,
                              double frames_per_second, bool loops);

/// Returns, for each frame of the retimed limb, the (fractional) source frame in the original if
/// the original's intervals are given these durations. Segments of about `segment_seconds` keep
/// their length, so that limbs stay synchronised; the time curve is smoothed over ±0.1 s. Never
/// decreasing. A clip that does not loop keeps its ends; the source frames of a loop may lie before
/// its first frame or after its last.
std::vector<double> source_frames(std::span<const double> durations, double segment_seconds,
                                  double frames_per_second, bool loops);

inline constexpr double constant_segment_seconds = 1.5;
inline constexpr double acceleration_segment_seconds = 0.9;

/// Frames at which a foot lands, for `near_only`.
std::vector<int> contact_frames(const std::vector<FootPlant>& plants, int frame_count);

/// Retimes one limb of the clip by the source frame of each frame (`source_frames`).
void retime(Clip& clip, Limb limb, const std::vector<double>& sources);

/// The clip with the end joints of the given limbs moving at constant speed in each segment of
/// `constant_segment_seconds`, except in pauses.
Clip with_constant_speed(const Clip& clip, const Limbs& limbs);

/// The clip with all pauses of the given limbs stretched (full acceleration).
Clip with_acceleration(const Clip& clip, const Limbs& limbs);

/// Like with_acceleration, but only near the given frames.
Clip with_acceleration_near(const Clip& clip, const Limbs& limbs, std::span<const int> moments);

}  // namespace mien::motion
