#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/modify/modification.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/style_step.h"

namespace mien::pipeline {

/// A pose that stands still: a frame of an example or of a motion file.
struct PoseSource {
  std::string example;         ///< empty: a file
  std::filesystem::path file;  ///< resolved
  std::string take;            ///< of a file with several; empty: its first
  int frame = 0;

  friend bool operator==(const PoseSource&, const PoseSource&) = default;
};

/// The motion of a pose: a file when the text ends like one, else an example.
struct PoseMotionForm {
  static void read(const DocumentValue& given, PoseSource& pose);
  static nlohmann::ordered_json write(const PoseSource& pose, const WritingOptions& how);
};

void fields_of(auto&& field, MaybeConst<PoseSource> auto& pose) {
  field.by("motion", pose, concerns::motion | concerns::required | concerns::alone,
           PoseMotionForm());
  field("take", pose.take, concerns::motion);
  field("frame", pose.frame, concerns::motion);
}

/// A posture as the difference of two captured standing poses.
struct PoseDifferenceSource {
  PoseSource neutral;
  PoseSource posed;

  friend bool operator==(const PoseDifferenceSource&, const PoseDifferenceSource&) = default;
};

void fields_of(auto&& field, MaybeConst<PoseDifferenceSource> auto& pose) {
  field("neutral", pose.neutral, concerns::motion);
  field("posed", pose.posed, concerns::motion);
}

inline constexpr Words<motion::RotationSignal> signal_words = {
    {"direction-vectors", motion::RotationSignal::direction_vectors},
    {"quaternions", motion::RotationSignal::quaternions}};
inline constexpr Words<motion::AccelerationPlace> acceleration_words = {
    {"pauses", motion::AccelerationPlace::pauses},
    {"contacts", motion::AccelerationPlace::contacts}};
inline constexpr Words<motion::FootRepair> repair_words = {
    {"plants", motion::FootRepair::plants},
    {"hip-shift", motion::FootRepair::hip_shift},
    {"none", motion::FootRepair::none}};

void fields_of(auto&& field, MaybeConst<motion::PathGains> auto& gains) {
  field("low", gains.low, concerns::motion);
  field("middle", gains.middle, concerns::motion);
  field("high", gains.high, concerns::motion);
  field("bands", gains.bands, concerns::motion);
}

/// `limbs: [head, left-hand]`: head, hands, feet and single ones of these.
struct LimbsForm {
  static void read(const DocumentValue& given, motion::Limbs& limbs);
  static nlohmann::ordered_json write(const motion::Limbs& limbs, const WritingOptions&);
};

/// `posture: {head-flexion: 12}`: units that it names take the place of the same units.
struct PostureForm {
  static void read(const DocumentValue& given, std::vector<motion::PostureChange>& posture);
  static nlohmann::ordered_json write(const std::vector<motion::PostureChange>& posture,
                                      const WritingOptions&);
  static void walk(auto& names) {
    for (const motion::PostureUnitName& unit : motion::posture_units())
      names.add(std::string(unit.name));
  }
};

void fields_of(auto&& field, MaybeConst<motion::Modification> auto& modification) {
  field("paths", modification.paths, concerns::motion);
  field("gains", modification.gains, concerns::motion);
  field("signal", modification.signal, concerns::motion, signal_words);
  field("acceleration", modification.acceleration, concerns::motion);
  field("acceleration_at", modification.acceleration_place, concerns::motion, acceleration_words);
  field.by("limbs", modification.limbs, concerns::motion, LimbsForm());
  field.by("posture", modification.posture, concerns::motion, PostureForm());
  field("tempo", modification.tempo, concerns::motion);
  field("variation", modification.variation, concerns::motion);
  field("seed", modification.seed, concerns::motion);
  field("repair", modification.repair, concerns::motion, repair_words);
  field("soft_limits", modification.soft_joint_limits, concerns::motion);
}

/// What a recipe or a manifest says of a modification. What it leaves out stays as it is.
struct ModificationEdit {
  motion::Modification values;  ///< of which those count that are named
  std::set<std::string> named;  ///< "paths", "posture", …
  std::optional<PoseDifferenceSource> pose;

  bool names(const std::string& option) const { return named.contains(option); }
};

/// The members of a map that say something of a modification.
struct EditForm {
  static void read(const DocumentValue& given, ModificationEdit& edit);
  static nlohmann::ordered_json write(const ModificationEdit& edit, const WritingOptions& how);
  static void walk(auto& names) {
    names.template of<motion::Modification>();
    std::optional<PoseDifferenceSource> pose;
    names("pose", pose, concerns::motion);
  }
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

void fields_of(auto&& field, MaybeConst<Recipe> auto& recipe) {
  field("ja", recipe.japanese, concerns::page);
  field("note", recipe.note, concerns::page);
  field.inside(recipe.edit, concerns::motion, EditForm());
}

/// What is done about a motion whose lint finds errors that the original does not have.
enum class OnFault {
  warn,    ///< it is made, and the report says so (default)
  fail,    ///< the run stops with an error
  revert,  ///< the motion is left unmodified, and the report says so
  reduce,  ///< it is modified only as strongly as is clean, and the report states how strongly
};

inline constexpr Words<OnFault> fault_words = {{"warn", OnFault::warn},
                                               {"fail", OnFault::fail},
                                               {"revert", OnFault::revert},
                                               {"reduce", OnFault::reduce}};

inline std::string_view name_of(OnFault choice) { return word_of(fault_words, choice); }

/// One change of a motion, in the order of the manifest.
struct ModificationStep {
  std::string path;       ///< in the manifest: "stimuli[2].modify" or "stimuli[2].modify[0]"
  std::string emotion;    ///< a recipe's name; empty for none
  double strength = 1.0;  ///< of recipe and edit together
  ModificationEdit edit;  ///< over the recipe
  motion::Modification modification;         ///< the recipe with the edit over it, at strength 1
  std::optional<PoseDifferenceSource> pose;  ///< not yet part of the modification
  std::optional<StyleStep> style;            ///< an older method, instead of all this but strength
};

/// The members of a map that name an older method and its options.
struct StyleForm {
  static void read(const DocumentValue& given, std::optional<StyleStep>& style);
  static nlohmann::ordered_json write(const std::optional<StyleStep>& style,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<StyleStep>(); }
};

/// As it is written. (What its artifacts depend on is `modification`, `pose` and `style`.)
void fields_of(auto&& field, MaybeConst<ModificationStep> auto& step) {
  field("emotion", step.emotion, concerns::motion);
  field("strength", step.strength, concerns::motion);
  field.inside(step.edit, concerns::motion, EditForm());
  field.inside(step.style, concerns::motion, StyleForm());
}

}  // namespace mien::pipeline
