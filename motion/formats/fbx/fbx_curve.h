#pragma once

#include <cstdint>
#include <vector>

#include "motion/formats/fbx/fbx_document.h"

namespace mien::motion {

/// Units of time in FBX files per second.
inline constexpr std::int64_t fbx_ticks_per_second = 46'186'158'000;

/// A key of a curve, and how the curve goes on to the next key.
struct FbxKey {
  enum class To : std::uint8_t { constant, constant_next, linear, cubic };

  std::int64_t time = 0;  ///< ticks
  float value = 0.0f;     ///< of the precision that the format stores
  To to = To::constant;
};

/// The tangents of a cubic curve between a key and the next one.
struct FbxTangents {
  float right_slope = 0.0f;      ///< after the key, units per second
  float next_left_slope = 0.0f;  ///< before the next key
  /// Lengths along time, as shares of the time between the keys.
  float right_weight = 1.0f / 3.0f;
  float next_left_weight = 1.0f / 3.0f;
};

/// A number over time. Before the first key and after the last it keeps their values.
struct FbxCurve {
  std::vector<FbxKey> keys;           ///< with times that do not decrease
  std::vector<FbxTangents> tangents;  ///< of the keys; empty if none is cubic
};

/// The curve of a node "AnimationCurve" (version 7000 and later): KeyTime, KeyValueFloat, and by
/// run lengths KeyAttrFlags, KeyAttrDataFloat and KeyAttrRefCount. Throws mien::Error if they have
/// different lengths, times decrease or numbers are not finite.
///
/// Flags: 0x2 constant (with 0x100: the next key's value), 0x4 linear, 0x8 cubic; tangents of cubic
/// curves: 0x100 automatic (the slope between the neighbours, 0 at the ends; with 0x1000 or 0x4000
/// without overshoot), 0x200 by tension, continuity and bias (Kochanek and Bartels 1984), others
/// by slopes in the file; 0x1000000 and 0x2000000: weighted tangents. Data of a key: slope to the
/// right, slope at the next key from the left, two weights (uint16, in 1/9999), velocities
/// (unused).
FbxCurve parse_fbx_curve(const FbxDocument& document, std::uint32_t node);

/// The curve of a node "Channel" of the section "Takes" (before version 7000): `Key: time, value,
/// L` (linear), `C` with `s` or `n` (constant), or `U` (cubic) with `s` or `b` and two slopes, `a`
/// or `p` (automatic) or `t` and three numbers, then letters for weights, each followed by as many
/// numbers as it needs. Empty if the channel has no keys. Throws mien::Error if keys are of another
/// form or not as many as `KeyCount` states.
FbxCurve parse_old_fbx_curve(const FbxDocument& document, std::uint32_t node);

/// The value at a time (ticks); the curve has keys. A key at most a thousandth of a frame later
/// counts as reached.
double value_at(const FbxCurve& curve, std::int64_t time);

/// Whether any two keys have different values.
bool changes(const FbxCurve& curve);

}  // namespace mien::motion
