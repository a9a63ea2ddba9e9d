#pragma once

#include <functional>
#include <vector>

#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison.h"

namespace mien::pipeline {

/// The three states of a stimulus from which causes are found.
struct StimulusStates {
  const StimulusFacts& approved;  ///< as the baseline has it
  const StimulusFacts& then;      ///< what was approved, as this program makes it
  const StimulusFacts& now;       ///< as the manifest describes it now

  bool is_motion_remade() const { return then.motion != approved.motion; }
  bool is_motion_requested() const { return now.motion != then.motion; }
  bool is_scene_remade() const { return then.scene != approved.scene; }
  bool is_scene_requested() const { return now.scene != then.scene; }
  bool is_drawing_requested() const { return now.drawing != then.drawing; }
};

/// The changed settings of one aspect: "weights.sad 0.4 → 0.41; …". Without any, all changed
/// settings: a seed may change a motion too, by the ratings that it simulates. Without any at all,
/// a sentence that the change comes from other stimuli.
std::string requested_changes(const StimulusStates& states, Aspect aspect);

/// What made the motion another, without shares. Empty when it is the same.
std::vector<Attribution> motion_causes(const StimulusStates& states);

/// Why the same motion, staged and drawn with the same settings, looks different: the program, a
/// library, the processor, a file that the scene is made from.
std::vector<Attribution> program_causes(const StimulusStates& states);

/// What made the same frames another file.
Attribution encoder_cause(const StimulusFacts& before, const StimulusFacts& now);

/// Which of motion, scene and drawing are taken from the current study; the rest is as approved.
struct Exchanged {
  bool motion = false;
  bool scene = false;
  bool drawing = false;

  friend auto operator<=>(const Exchanged&, const Exchanged&) = default;
};

/// Shares of the mean squared error between two pictures.
struct CauseShares {
  double program = 0.0;  ///< of what is not exchanged
  double motion = 0.0;
  double scene = 0.0;
  double drawing = 0.0;
  double interaction = 0.0;  ///< of what none of them does alone; may be negative
};

/// Exchanges one after the other, in each order: the mean of what each adds is its Shapley value
/// (1953). `error_of` returns the mean squared error between the picture of such a state and that
/// of none exchanged; it is called once for each set of those that `can` be. `program_error` is
/// that between the approved picture and that of none exchanged. All 0 when there is no error.
CauseShares cause_shares(const Exchanged& can, double program_error,
                         const std::function<double(const Exchanged&)>& error_of);

}  // namespace mien::pipeline
