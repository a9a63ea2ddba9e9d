#include "motion/procedural/expressive_walks.h"

#include <array>
#include <cmath>
#include <limits>

namespace mien::motion {

namespace {

enum Mood { brisk, slow, happy, sad, angry, proud, afraid, tired, relaxed, excited, strong, weak };

using ByMood = std::array<double, weak + 1>;

struct Expressed {
  double WalkStyle::*parameter;
  ByMood values;
};

// The columns are the moods in their order; `o`: as an ordinary walk has it.
constexpr double o = std::numeric_limits<double>::quiet_NaN();

constexpr ByMood speeds_m_s = {1.75, 0.85, 1.48, 0.80, 1.68, 1.22,
                               0.72, 0.70, 1.12, 1.66, 1.40, 0.66};
constexpr ByMood cadences_steps_min = {126, 86, 117, 84, 122, 102, 98, 80, 97, 128, 104, 86};
constexpr ByMood bounce_factors = {1, 1, 1.3, 0.8, 1, 1, 0.7, 1, 1, 1.35, 1, 0.8};

using W = WalkStyle;

constexpr Expressed table[] = {
    {&W::stance_share, {o, o, o, o, o, o, o, 0.67, o, o, o, 0.66}},
    {&W::step_width_m, {o, o, o, o, 0.11, 0.11, 0.07, 0.12, 0.10, o, 0.14, 0.08}},
    {&W::foot_progression_deg, {o, o, o, o, o, 13, 1, o, 12, o, 13, o}},
    {&W::heel_strike_deg, {o, o, o, o, 24, 23, 6, 7, o, o, 24, 6}},
    {&W::heel_rise_share, {o, o, 0.26, o, o, o, o, o, o, 0.25, o, o}},
    {&W::toe_off_deg, {o, o, o, o, o, o, o, 50, o, o, o, 52}},
    {&W::swing_knee_deg, {o, o, 66, o, o, o, o, 52, o, 70, o, 52}},
    {&W::stance_knee_deg, {o, o, o, 8, 7, o, 20, 12, o, o, o, 13}},
    {&W::foot_clearance_m, {o, o, 0.025, 0.010, o, 0.022, 0.025, 0.006, o, 0.03, o, 0.009}},
    {&W::sway_m, {o, 0.054, 0.05, 0.060, o, 0.05, 0.030, 0.085, 0.056, 0.05, 0.055, 0.055}},
    {&W::pelvis_rotation_deg, {o, o, o, o, o, o, o, o, 7, 8, o, o}},
    {&W::pelvis_obliquity_deg, {o, o, 5, o, o, o, o, o, 5.5, o, o, o}},
    {&W::pelvis_tilt_deg, {o, o, o, 2, o, 6, 0, 0, 2, o, o, 2}},
    {&W::trunk_lean_deg, {3, o, -1, 6, 8, -4, 6, 9, -4, 2, 1, 4}},
    {&W::chest_flexion_deg, {o, o, -5, 16, 6, -9, 14, 13, 4, -4, -6, 10}},
    {&W::trunk_rotation_deg, {6.5, o, 9, 2.5, 9, 7, 2, 3, o, 11, 9, 2}},
    {&W::trunk_sway_deg, {o, o, o, o, o, 2, o, 5, 2, o, 2.5, 3}},
    {&W::neck_flexion_deg, {o, o, 6, 36, 24, 0, 30, 32, 14, 8, 8, 22}},
    {&W::head_pitch_deg, {o, o, -6, 30, 8, -10, 4, 16, -2, -5, -1, 8}},
    {&W::head_sway_deg, {o, o, 3, o, o, o, o, 6, 2, 4, o, o}},
    {&W::shoulder_elevation_deg, {o, o, -4, -10, 3, -3, 9, -11, -8, -2, -1, -9}},
    {&W::shoulder_protraction_deg, {o, o, -3, 14, 6, -10, 16, 8, o, o, -4, 10}},
    {&W::arm_swing_deg, {52, o, 60, 10, 50, 40, 7, 16, 40, 70, 50, 7}},
    {&W::arm_flexion_deg, {o, o, -2, 2, -2, -8, 4, 6, o, 0, o, 2}},
    {&W::arm_abduction_deg, {o, o, 14, 7, 19, 17, 5, 9, 12, 17, 24, 4}},
    {&W::arm_rotation_deg, {o, o, 14, o, 22, 4, 20, o, o, o, 26, o}},
    {&W::elbow_flexion_deg, {34, o, 28, 12, 56, 26, 112, 9, 19, 52, 34, 18}},
    {&W::elbow_swing_deg, {32, o, 32, 5, 34, o, 6, 6, 20, 40, 26, 3}},
    {&W::forearm_pronation_deg, {o, o, o, o, 45, o, o, o, o, o, 50, o}},
    {&W::wrist_flexion_deg, {o, o, o, o, 12, o, 18, o, o, o, o, o}},
    {&W::wrist_swing_deg, {o, o, o, 4, 2, o, 2, 12, 18, o, o, 5}},
    {&W::arm_lag_share, {o, o, o, o, 0.02, o, o, 0.09, 0.075, o, o, o}},
    {&W::sharpness, {o, o, o, -0.3, 0.7, o, 0.4, -0.7, -0.6, 0.35, 0.3, -0.2}},
    {&W::impact_m, {o, o, o, o, 0.014, o, o, 0.010, o, o, 0.010, o}},
};

WalkStyle expressive_walk(Mood mood) {
  WalkStyle style = ordinary_walk(speeds_m_s[mood], cadences_steps_min[mood]);
  style.bounce_m *= bounce_factors[mood];
  for (const auto& [parameter, values] : table)
    if (!std::isnan(values[mood])) style.*parameter = values[mood];
  return style;
}

}  // namespace

WalkStyle brisk_walk() { return expressive_walk(brisk); }
WalkStyle slow_walk() { return expressive_walk(slow); }
WalkStyle happy_walk() { return expressive_walk(happy); }
WalkStyle sad_walk() { return expressive_walk(sad); }
WalkStyle angry_walk() { return expressive_walk(angry); }
WalkStyle proud_walk() { return expressive_walk(proud); }
WalkStyle afraid_walk() { return expressive_walk(afraid); }
WalkStyle tired_walk() { return expressive_walk(tired); }
WalkStyle relaxed_walk() { return expressive_walk(relaxed); }
WalkStyle excited_walk() { return expressive_walk(excited); }
WalkStyle strong_walk() { return expressive_walk(strong); }
WalkStyle weak_walk() { return expressive_walk(weak); }

}  // namespace mien::motion
