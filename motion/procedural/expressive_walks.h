#pragma once

#include "motion/procedural/walk_style.h"

namespace mien::motion {

/// Expressive walks. Their differences from an ordinary walk follow studies of emotional gait;
/// where the studies report no amounts, the amounts are our own choice.

/// A fast ordinary walk.
WalkStyle brisk_walk();

/// A slow ordinary walk.
WalkStyle slow_walk();

/// Fast and upright, with much arm swing and vertical movement and a light step (Montepare et al.
/// 1987; Michalak et al. 2009).
WalkStyle happy_walk();

/// Slow and slumped, with little arm swing, a hanging head, more lateral and less vertical movement
/// (Michalak et al. 2009; Roether et al. 2009).
WalkStyle sad_walk();

/// Fast, long strides, elbows flexed, leaning forward, heavy-footed (Montepare et al. 1987; Roether
/// et al. 2009; Barliya et al. 2013).
WalkStyle angry_walk();

/// Upright, chest out, chin up, arms and feet apart: expansive (Montepare et al. 1987; Gross, Crane
/// and Fredrickson 2012).
WalkStyle proud_walk();

/// Contracted: slow, short steps, elbows and knees held flexed, shoulders raised (Roether et al.
/// 2009; Barliya et al. 2013).
WalkStyle afraid_walk();

/// Slow, dragging and heavy, arms hanging, head and trunk bent, swaying.
WalkStyle tired_walk();

/// Unhurried and loose: lagging, floating forearms, a slight backward lean, a soft sway (Crane and
/// Gross 2013 on contentment).
WalkStyle relaxed_walk();

/// Fast, springy, with wide swings of bent arms that start abruptly, head up (Montepare et al. 1987
/// and Roether et al. 2009 on joy; more pronounced than happy_walk).
WalkStyle excited_walk();

/// Firm, broad and heavy: arms abducted and internally rotated, chest out, feet apart, full steps
/// (Montepare et al. 1987 on pride and anger; the strong posture of the emotion thesis).
WalkStyle strong_walk();

/// Slow, short and low steps, arms close to the trunk and hardly swinging, knees and trunk a little
/// bent.
WalkStyle weak_walk();

}  // namespace mien::motion
