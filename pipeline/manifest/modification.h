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
#include "pipeline/manifest/animation.h"
#include "pipeline/manifest/recording_choice.h"
#include "pipeline/manifest/relative_fields.h"
#include "pipeline/manifest/style_step.h"

namespace mien::pipeline {

/// A static pose: a frame of an example or of a motion file.
struct PoseSource {
  std::string example;         ///< empty: `file` is used
  std::filesystem::path file;  ///< resolved
  RecordingChoice how;         ///< which motion of the file
  int frame = 0;               ///< counted from 0

  friend bool operator==(const PoseSource&, const PoseSource&) = default;
};

/// The motion of a pose: a file if the text ends in a motion file's extension, otherwise an
/// example.
struct PoseMotionForm {
  static void read(const DocumentValue& given, PoseSource& pose);
  static nlohmann::ordered_json write(const PoseSource& pose, const WritingOptions& how);
};

void fields_of(auto&& field, MaybeConst<PoseSource> auto& pose) {
  field.by("motion", pose, concerns::motion | concerns::required | concerns::alone,
           PoseMotionForm());
  pose_fields(field, pose.how, concerns::motion);
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
inline constexpr Words<motion::FingerPaths> finger_path_words = {
    {"keep", motion::FingerPaths::kept}, {"scale", motion::FingerPaths::scaled}};
inline constexpr Words<motion::AccelerationPlace> acceleration_words = {
    {"pauses", motion::AccelerationPlace::pauses},
    {"contacts", motion::AccelerationPlace::contacts},
    {"hits", motion::AccelerationPlace::hits}};
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

/// `limbs: [head, left-hand]`: head, hands, feet, or a single hand or foot.
struct LimbsForm {
  static void read(const DocumentValue& given, motion::Limbs& limbs);
  static nlohmann::ordered_json write(const motion::Limbs& limbs, const WritingOptions&);
};

/// `posture: {head-flexion: 12}`: a rotation (motion::posture_units) given here replaces the
/// recipe's rotation of the same name.
struct PostureForm {
  static void read(const DocumentValue& given, std::vector<motion::PostureChange>& posture);
  static nlohmann::ordered_json write(const std::vector<motion::PostureChange>& posture,
                                      const WritingOptions&);
  static void walk(auto& names) {
    for (const motion::PostureUnitName& unit : motion::posture_units())
      names.add(std::string(unit.name));
  }
};

inline constexpr Words<motion::TempoGravity> gravity_words = {
    {"scaled", motion::TempoGravity::scaled}, {"keep", motion::TempoGravity::kept}};

/// `tempo: 1.2`, or a curve: `tempo: [[0, 1], [0.5, 1.4]]`, shares of the duration and factors.
struct TempoForm {
  static void read(const DocumentValue& given, motion::Tempo& tempo);
  static nlohmann::ordered_json write(const motion::Tempo& tempo, const WritingOptions&);
};

/// The path of what is wrong with the tempo at `path`: "modify.tempo[1][0]".
std::string path_of(const motion::TempoFault& fault, const std::string& path);

/// `stiffness: 0.4`, or by part: `stiffness: {arms: 0.3, head: 0.5}`; parts that are not named are
/// as they are. Given in a manifest, it replaces the recipe's.
struct StiffnessForm {
  static void read(const DocumentValue& given, motion::Stiffness& stiffness);
  static nlohmann::ordered_json write(const motion::Stiffness& stiffness, const WritingOptions&);
  static void walk(auto& names) {
    for (const char* part : {"head", "trunk", "arms", "left-arm", "right-arm", "legs"})
      names.add(part);
  }
};

/// "arms 0.3, head 0.5", the parts whose stiffness is not 1.
std::string text_of(const motion::Stiffness& stiffness);

void fields_of(auto&& field, MaybeConst<motion::Modification> auto& modification) {
  field("paths", modification.paths, concerns::motion);
  field("gains", modification.gains, concerns::motion);
  field("signal", modification.signal, concerns::motion, signal_words);
  field("hands", modification.hands, concerns::motion, finger_path_words);
  field("acceleration", modification.acceleration, concerns::motion);
  field("acceleration_at", modification.acceleration_place, concerns::motion, acceleration_words);
  field.by("limbs", modification.limbs, concerns::motion, LimbsForm());
  field.by("posture", modification.posture, concerns::motion, PostureForm());
  field.by("gesture", modification.gesture, concerns::motion, GestureForm());
  relative_fields(field, modification.relative);
  field.by("tempo", modification.tempo, concerns::motion, TempoForm());
  field("gravity", modification.gravity, concerns::motion, gravity_words);
  field.by("stiffness", modification.stiffness, concerns::motion, StiffnessForm());
  field("weight", modification.weight, concerns::motion);
  field("variation", modification.variation, concerns::motion);
  field("seed", modification.seed, concerns::motion);
  field("repair", modification.repair, concerns::motion, repair_words);
  field("soft_limits", modification.soft_joint_limits, concerns::motion);
}

/// The settings of a modification that a recipe or a manifest states; all others remain unchanged.
struct ModificationEdit {
  motion::Modification values;  ///< only the options in `named` are valid
  std::set<std::string> named;  ///< stated options: "paths", "posture", …
  std::optional<PoseDifferenceSource> pose;

  bool names(const std::string& option) const { return named.contains(option); }
};

/// The members of a map that belong to a modification.
struct EditForm {
  static void read(const DocumentValue& given, ModificationEdit& edit);
  static nlohmann::ordered_json write(const ModificationEdit& edit, const WritingOptions& how);
  static void walk(auto& names) {
    names.template of<motion::Modification>();
    std::optional<PoseDifferenceSource> pose;
    names("pose", pose, concerns::motion);
  }
};

/// Returns the modification with the stated settings of the edit applied, except `edit.pose`, which
/// is ignored.
motion::Modification with_edit(motion::Modification modification, const ModificationEdit& edit);

/// A recipe for an emotion: one of our own (builtin), a row of figure 29 of the emotion thesis
/// (fig29), or the user's own.
struct Recipe {
  std::string name;  ///< "sad", "energetic-sad"
  std::string japanese;
  std::string note;  ///< description in one sentence
  ModificationEdit edit;
};

void fields_of(auto&& field, MaybeConst<Recipe> auto& recipe) {
  field("ja", recipe.japanese, concerns::page);
  field("note", recipe.note, concerns::page);
  field.inside(recipe.edit, concerns::motion, EditForm());
}

/// The treatment of a modified motion in which the lint finds errors that the original does not
/// have.
enum class OnFault {
  warn,    ///< keep the motion and report a warning (default)
  fail,    ///< do not make the motion: its task fails with an error, other tasks continue
  revert,  ///< leave the motion unmodified and report a warning
  reduce,  ///< reduce the modification until there are no new errors, and report the remaining
           ///< strength
};

inline constexpr Words<OnFault> fault_words = {{"warn", OnFault::warn},
                                               {"fail", OnFault::fail},
                                               {"revert", OnFault::revert},
                                               {"reduce", OnFault::reduce}};

inline std::string_view name_of(OnFault choice) { return word_of(fault_words, choice); }

/// One modification of a motion.
struct ModificationStep {
  std::string path;       ///< path in the manifest: "stimuli[2].modify" or "stimuli[2].modify[0]"
  std::string emotion;    ///< a recipe's name; empty for none
  double strength = 1.0;  ///< strength of recipe and edit together
  ModificationEdit edit;  ///< applied to the recipe
  motion::Modification modification;         ///< the recipe with the edit applied, at strength 1
  std::optional<PoseDifferenceSource> pose;  ///< not yet included in `modification`
  /// An older method. If it is set, `strength` is the only other setting that is used.
  std::optional<StyleStep> style;
  /// Of the last step only, at any strength: applied when all steps are made.
  motion::Freezing freeze;
  std::vector<motion::DriveEditing> drives;
  std::vector<motion::AnimatorKey> keys;
  std::vector<motion::MotionConstraint> constraints;
  motion::MotionEnds ends;
};

/// The members of a map that belong to an older method: its name and options.
struct StyleForm {
  static void read(const DocumentValue& given, std::optional<StyleStep>& style);
  static nlohmann::ordered_json write(const std::optional<StyleStep>& style,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<StyleStep>(); }
};

/// The fields as written in the manifest. (Keys of artifacts contain the resolved `modification`
/// and `pose` instead of `edit`.)
void fields_of(auto&& field, MaybeConst<ModificationStep> auto& step) {
  field("emotion", step.emotion, concerns::motion);
  field("strength", step.strength, concerns::motion);
  field.inside(step.edit, concerns::motion, EditForm());
  field.inside(step.style, concerns::motion, StyleForm());
  field.by("freeze", step.freeze, concerns::motion, FreezingForm());
  field("drives", step.drives, concerns::motion);
  field("keys", step.keys, concerns::motion);
  field("constraints", step.constraints, concerns::motion);
  field.by("ends", step.ends, concerns::motion, EndsForm());
}

}  // namespace mien::pipeline
