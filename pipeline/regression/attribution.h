#pragma once

#include <functional>
#include <vector>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison.h"

namespace mien::pipeline {

/// The three states of a stimulus that are compared to find causes.
struct StimulusStates {
  const StimulusFacts& approved;  ///< as stored in the baseline
  const StimulusFacts& then;      ///< from the approved manifest, made by the current program
  const StimulusFacts& now;       ///< from the current manifest, made by the current program

  // Remade: from the approved manifest, the current program makes something that differs from what
  // was approved. Requested: what the current program makes from the current manifest differs from
  // what it makes from the approved manifest.
  bool is_motion_remade() const { return then.motion != approved.motion; }
  bool is_motion_requested() const { return now.motion != then.motion; }
  bool is_scene_remade() const { return then.scene != approved.scene; }
  bool is_scene_requested() const { return now.scene != then.scene; }
  bool is_drawing_requested() const { return now.drawing != then.drawing; }
};

/// Returns the changed settings of one aspect: "weights.sad 0.4 → 0.41; …". If no setting of this
/// aspect has changed, returns all changed settings, because settings of another aspect may be the
/// cause: a seed may change a motion through simulated ratings. If nothing has changed, returns
/// "equalization across the study's stimuli".
std::string requested_changes(const StimulusStates& states, Aspect aspect);

/// Returns the causes of a changed motion, without shares; empty if the motion is unchanged.
std::vector<Attribution> motion_causes(const StimulusStates& states);

/// Returns the causes of a different appearance of the same motion, staged and rendered with the
/// same settings: the program, a library, the processor, or a file of the scene.
std::vector<Attribution> program_causes(const StimulusStates& states);

/// Returns the causes of changed videos, of which there is at least one, if motion and key frames
/// are the same.
std::vector<Attribution> video_causes(const StimulusFacts& before, const StimulusFacts& now,
                                      const std::vector<VideoChange>& videos);

/// Returns the changed presentation as a cause of changed videos, whatever else has changed; empty
/// if it has not changed, or if the videos are known to show the same frames.
std::vector<Attribution> presentation_causes(const StimulusFacts& before, const StimulusFacts& now,
                                             const std::vector<VideoChange>& videos);

/// The aspects taken from the current study; the others are as approved.
struct Exchanged {
  bool motion = false;
  bool scene = false;
  bool drawing = false;

  friend auto operator<=>(const Exchanged&, const Exchanged&) = default;
};

/// Shares of the causes in the mean squared error between two pictures.
struct CauseShares {
  /// Share of the program, its libraries and the processor, which are not exchanged.
  double program = 0.0;
  double motion = 0.0;
  double scene = 0.0;
  double drawing = 0.0;
  /// Error of all exchanged aspects together minus the sum of the errors of each alone; contained
  /// in the other shares; may be negative.
  double interaction = 0.0;
};

/// Computes Shapley values (1953): the contribution of each aspect, averaged over all orders of
/// exchanging the aspects one after the other. `error_of` returns the mean squared error between
/// the picture with the given aspects exchanged and that with none exchanged; it is called once for
/// each nonempty subset of the aspects in `can`. `program_error` is the error between the approved
/// picture and that with none exchanged. All shares are relative to the sum of this error and that
/// with all aspects in `can` exchanged; they are 0 if there is no error.
CauseShares cause_shares(const Exchanged& can, double program_error,
                         const std::function<double(const Exchanged&)>& error_of);

}  // namespace mien::pipeline
