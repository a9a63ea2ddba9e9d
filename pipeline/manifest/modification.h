#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/modify/modification.h"
#include "pipeline/manifest/style_step.h"

namespace mien::pipeline {

/// A pose that stands still: a frame of an example or of a motion file.
struct PoseSource {
  std::string example;         ///< empty: a file
  std::filesystem::path file;  ///< resolved
  int frame = 0;

  friend bool operator==(const PoseSource&, const PoseSource&) = default;
};

/// A posture as the difference of two captured standing poses.
struct PoseDifferenceSource {
  PoseSource neutral;
  PoseSource posed;

  friend bool operator==(const PoseDifferenceSource&, const PoseDifferenceSource&) = default;
};

/// What a recipe or a manifest says of a modification. What it leaves out stays as it is.
struct ModificationEdit {
  std::optional<double> paths;
  std::optional<motion::PathGains> gains;
  std::optional<motion::RotationSignal> signal;
  std::optional<double> acceleration;
  std::optional<motion::AccelerationPlace> acceleration_place;
  std::optional<motion::Limbs> limbs;
  std::vector<motion::PostureChange> posture;  ///< units it names take the place of the same units
  std::optional<PoseDifferenceSource> pose;
  std::optional<double> tempo;
  std::optional<double> variation;
  std::optional<std::uint64_t> seed;
  std::optional<motion::FootRepair> repair;
  std::optional<bool> soft_limits;
};

/// The modification with what the edit says over it. The pose difference is not read here.
motion::Modification with_edit(motion::Modification modification, const ModificationEdit& edit);

/// How a motion is given an emotion: a row of figure 29 of the emotion thesis, or the user's own.
struct Recipe {
  std::string name;  ///< "sad", "energetic-sad"
  std::string japanese;
  std::string note;  ///< a sentence on what it does
  ModificationEdit edit;
};

/// What is done about a motion whose lint finds errors that the original does not have.
enum class OnFault {
  warn,    ///< it is made, and the report tells (default)
  fail,    ///< the run stops with an error
  revert,  ///< the motion is left unmodified, and the report tells
  reduce,  ///< it is modified only as strongly as is clean, and the report tells how strongly
};

/// "warn", "fail", "revert", "reduce".
std::string_view name_of(OnFault choice);

/// One change of a motion, in the order of the manifest.
struct ModificationStep {
  std::string path;       ///< in the manifest: "stimuli[2].modify" or "stimuli[2].modify[0]"
  std::string emotion;    ///< a recipe's name; empty for none
  double strength = 1.0;  ///< of recipe and edit together
  ModificationEdit edit;  ///< over the recipe
  motion::Modification modification;         ///< the recipe with the edit over it, at strength 1
  std::optional<PoseDifferenceSource> pose;  ///< likewise; not yet part of the modification
  std::optional<StyleStep> style;            ///< an older method, instead of all this but strength
};

}  // namespace mien::pipeline
