#pragma once

#include <array>

#include "motion/walk_style.h"

namespace mien::motion {

/// The impressions that simulated ratings are made of. Order of `StyleProfile`.
enum StyleImpression : int {
  Quickness,
  Clearness,
  Activeness,
  Largeness,
  Valence,
  Arousal,
  Tension,
  Stability,
};

inline constexpr int style_impression_count = 8;

/// One value in (−1, 1) an impression, 0 near an ordinary walk.
using StyleProfile = std::array<double, style_impression_count>;

/// What a style looks like, from its parameters alone: each impression is tanh of a weighted sum of
/// cues, every cue a parameter's departure from an ordinary walk in units of a clearly visible
/// change. The signs are the findings of perception studies of gait (Montepare et al. 1987; Roether
/// et al. 2009; Michalak et al. 2009; Barliya et al. 2013: speed and amplitude of movement carry
/// arousal, upright posture, vertical movement and arm swing carry valence, limb flexion and raised
/// shoulders tension); the weights are ours.
StyleProfile profile(const WalkStyle& style);

}  // namespace mien::motion
