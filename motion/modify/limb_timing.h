#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/modify/modification.h"

namespace mien::motion {

/// A part of the body whose timing is changed as one: its joints keep together.
enum class Limb { head, left_hand, right_hand, left_foot, right_foot };

inline constexpr std::array<Limb, 5> all_limbs = {Limb::head, Limb::left_hand, Limb::right_hand,
                                                  Limb::left_foot, Limb::right_foot};

bool has(const Limbs& limbs, Limb limb);

/// Joints of a limb from proximal to distal. The trunk belongs to no limb: its timing is that of
/// the hips.
std::vector<BodyJoint> joints_of(Limb limb);

/// The end joint, whose speed represents the limb's: head, wrist or ankle.
BodyJoint end_of(Limb limb);

/// How fast the limb's end moves relative to the hips between each frame and the next, m/s, without
/// what is quicker than 12.5 Hz (0.3 of the frame rate, if that is less). A loop has as many
/// intervals as frames, another clip one less.
std::vector<double> limb_speeds(const Clip& clip, Limb limb);

/// How long each interval should last, in frames, so that the end's speed is constant: as its speed
/// over the mean, but at least 0.05. Where it pauses (slower than 0.05 m/s or a tenth of its top
/// speed) an interval lasts as long as one of mean speed.
std::vector<double> constant_speed_durations(std::span<const double> speeds);

/// Factor by which a pause is stretched at full acceleration. The thesis has 10, which leaves the
/// rest of a segment 2.5 times as quick: at 30 frames a second that is seen as jerks.
inline constexpr double max_pause_factor = 5.5;

/// How long each interval should last so that the end slows down more where it is slow, and is
/// quicker elsewhere: sets of 0.15 s (at least 3 intervals) that are slower than both their
/// neighbours last `pause_factor` times as long. What stands still all the while (below 0.05 m/s)
/// is left.
std::vector<double> accelerated_durations(std::span<const double> speeds, double frames_per_second,
                                          bool loops, double pause_factor = max_pause_factor);

/// Durations restricted to the neighbourhood of given frames: full effect within 0.1 s, none (1)
/// beyond 0.2 s.
std::vector<double> near_only(std::span<const double> durations, std::span<const int> moments,
                              double frames_per_second, bool loops);

/// For each frame the (fractional) frame of the original that is shown then, when intervals last
/// that long. Stretches of about `segment_seconds` keep their length, so that limbs stay together;
/// corners are rounded off over 0.1 s. Never decreasing; an open clip keeps its ends, a loop's
/// source may lie before its first frame or after its last.
std::vector<double> source_frames(std::span<const double> durations, double segment_seconds,
                                  double frames_per_second, bool loops);

inline constexpr double constant_segment_seconds = 1.5;
inline constexpr double acceleration_segment_seconds = 0.9;

/// Frames at which a foot lands; for `near_only`.
std::vector<int> contact_frames(const std::vector<FootPlant>& plants, int frame_count);

/// Retimes one limb of the clip.
void retime(Clip& clip, Limb limb, const std::vector<double>& sources);

/// The clip with constant speed of the limbs' end joints.
Clip with_constant_speed(const Clip& clip, const Limbs& limbs);

/// The clip with stretched pauses of its limbs (acceleration), everywhere.
Clip with_acceleration(const Clip& clip, const Limbs& limbs);

/// As with_acceleration, only near the given frames.
Clip with_acceleration_near(const Clip& clip, const Limbs& limbs, std::span<const int> moments);

}  // namespace mien::motion
