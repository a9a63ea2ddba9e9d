#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/interpolation/synthesis_options.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/factors.h"
#include "pipeline/manifest/foil.h"
#include "pipeline/manifest/hold.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/modification.h"
#include "pipeline/manifest/output.h"
#include "pipeline/manifest/recording_choice.h"
#include "pipeline/manifest/regression_limits.h"
#include "pipeline/manifest/stimulus_level.h"
#include "pipeline/manifest/stimulus_sound.h"
#include "pipeline/manifest/walk_path.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

/// Pairs of name and number, in the order of the manifest.
using NamedValues = std::vector<std::pair<std::string, double>>;

inline constexpr Words<motion::GridSource> grid_source_words = {
    {"cardinal", motion::GridSource::cardinal}, {"knn", motion::GridSource::nearest}};
inline constexpr Words<bool> drift_words = {{"linear", true}, {"constant", false}};
inline constexpr Words<motion::ModelEstimate> estimate_words = {
    {"expected", motion::ModelEstimate::expected},
    {"most-likely", motion::ModelEstimate::most_likely}};
inline constexpr Words<motion::RotationBlend> rotation_words = {
    {"karcher-mean", motion::RotationBlend::karcher_mean},
    {"direction-vectors", motion::RotationBlend::direction_vectors},
    {"markley-mean", motion::RotationBlend::markley_mean}};
inline constexpr Words<motion::WarpShape> time_warp_words = {
    {"monotone", motion::WarpShape::monotone}, {"linear", motion::WarpShape::linear}};

/// The method by which examples are blended into a clip.
using Interpolation = motion::SynthesisOptions;

void fields_of(auto&& field, MaybeConst<Interpolation> auto& how) {
  field("method", how.weights.method, concerns::motion, motion::interpolation_methods);
  field("neighbours", how.weights.nearest.neighbours, concerns::motion);
  field("blends", how.weights.nearest.trials, concerns::motion);
  field("power", how.weights.power, concerns::motion);
  field("cells", how.weights.grid_cells, concerns::motion);
  field("nodes", how.weights.grid_source, concerns::motion, grid_source_words);
  field("drift", how.weights.kriging.linear_drift, concerns::motion, drift_words);
  field("nugget", how.weights.kriging.nugget, concerns::motion);
  field("variance", how.weights.pca.variance_share, concerns::motion);
  field("estimate", how.weights.pca.estimate, concerns::motion, estimate_words);
  field("noise", how.weights.pca.noise, concerns::motion);
  field("step", how.weights.click_step, concerns::motion);
  field("rotations", how.rotations, concerns::motion, rotation_words);
  field("time_warp", how.time_warp, concerns::motion, time_warp_words);
  field("foot_lock", how.foot_lock, concerns::motion);
}

/// A motion file from which a stimulus takes its motion.
struct ClipSource {
  std::filesystem::path file;                ///< resolved
  RecordingChoice how;                       ///< which motion of the file
  std::optional<std::array<int, 2>> frames;  ///< first and last, counted from 0; all when absent
};

void fields_of(auto&& field, MaybeConst<ClipSource> auto& clip) {
  field("file", clip.file, concerns::motion | concerns::required | concerns::alone);
  recording_fields(field, clip.how, concerns::motion);
  field("frames", clip.frames, concerns::motion);
}

/// The role of a stimulus in comparisons: target, created or reference.
using Role = scenes::Role;

inline constexpr Words<Role> role_words = {
    {"target", Role::target}, {"created", Role::created}, {"reference", Role::reference}};

inline std::string_view name_of(Role role) { return word_of(role_words, role); }

/// `modify:`: one or more steps.
struct StepsForm {
  static void read(const DocumentValue& given, std::vector<ModificationStep>& steps);
  static nlohmann::ordered_json write(const std::vector<ModificationStep>& steps,
                                      const WritingOptions& how);
  static void walk(auto& names) { names.template of<ModificationStep>(); }
};

/// Where one of several people is on the stage: the pelvis at the beginning of the motion, on the
/// floor.
struct StagePlace {
  double x = 0.0;  ///< metres from the stage's middle, to the right as the front camera sees it
  double z = 0.0;  ///< metres from the stage's middle, towards the front camera
  /// Direction of the motion, degrees: 0 towards the front camera, 90 to the right of its picture.
  double turn = 0.0;
};

void fields_of(auto&& field, MaybeConst<StagePlace> auto& place) {
  field("x", place.x, concerns::picture);
  field("z", place.z, concerns::picture);
  field("turn", place.turn, concerns::picture);
}

struct Person;

/// One film to make. Exactly one of adjectives, features, weights, clip, path, foil and people is
/// given.
struct Stimulus {
  std::string path;  ///< path in the manifest: "stimuli[2]"
  std::string id;    ///< safe as a file name
  Role role = Role::created;
  Factors factors;         ///< stated factors of the design (levels_of returns all)
  StimulusLevel level;     ///< if it was made from a stimulus with `levels:`
  NamedValues adjectives;  ///< parameter → 0…1
  Hold hold;               ///< held parameters, only with `adjectives`
  NamedValues features;    ///< feature parameter → 0…1 (feature_parameters.h)
  NamedValues weights;     ///< example → share, ≥ 0, not all 0
  std::optional<ClipSource> clip;
  std::optional<WalkPath> walk;              ///< `path:`
  std::vector<ModificationStep> walk_moods;  ///< recipes named by the moods of a path through a
                                             ///< motion graph, in the order of their names
  /// If set, the motion is derived from the original stimulus (resolve_foils).
  std::optional<Foil> foil;
  std::optional<StatedSound> audio;
  std::optional<StimulusSound> sound;    ///< from `audio` (resolve_sounds)
  Look look;                             ///< the manifest's, with the stimulus's own values applied
  Output output;                         ///< the manifest's, with the stimulus's own values applied
  Interpolation interpolation;           ///< the manifest's, with the stimulus's own values applied
  std::vector<ModificationStep> modify;  ///< modifications of the motion, in order
  OnFault on_fault = OnFault::warn;      ///< the stimulus's own, otherwise the manifest's
  RegressionLimits regression;           ///< the manifest's, with the stimulus's own values applied
  std::vector<Person> people;            ///< with a motion each; the stimulus itself then has none
  /// Name of a person → stimulus, or person of a stimulus, whose motion that person takes.
  std::vector<std::pair<std::string, std::string>> swap;
};

/// One of several people in the film of a stimulus.
struct Person {
  std::string name;  ///< by default a, b, c …
  /// The person's motion as that of a stimulus "<stimulus>.<name>", which has no film of its own.
  Stimulus motion;
  std::optional<Stimulus> stated;        ///< the motion as stated, if `swap:` replaced it
  std::optional<StagePlace> place;       ///< if not given, the motion stays where it is
  double start = 0.0;                    ///< seconds of the film at which the motion begins
  std::optional<scenes::Figure> figure;  ///< a body; if not given, the figure of the stimulus
  std::optional<scenes::Face> face;      ///< of a character; if not given, that of the stimulus
  std::optional<scenes::Hands> hands;    ///< if not given, those of the stimulus
  std::string colour;                    ///< "#rrggbb"; if empty, by the person's number
};

/// Returns a person that has only the stimulus's defaults.
Person plain_person(const Stimulus& stimulus);

/// `figure:` of a person: one with a surface.
struct PersonFigureForm {
  static void read(const DocumentValue& given, std::optional<scenes::Figure>& figure);
  static nlohmann::ordered_json write(const std::optional<scenes::Figure>& figure,
                                      const WritingOptions& how);
  static void walk(auto& names) { FigureForm<scenes::BodyFigure>::walk(names); }
};

/// The keys that determine a motion.
void motion_fields(auto&& field, MaybeConst<Stimulus> auto& stimulus) {
  field("adjectives", stimulus.adjectives, concerns::motion);
  field.by("hold", stimulus.hold, concerns::motion, HoldForm());
  field("features", stimulus.features, concerns::motion);
  field("weights", stimulus.weights, concerns::motion);
  field("clip", stimulus.clip, concerns::motion);
  field.by("path", stimulus.walk, concerns::motion, WalkPathForm());
  field.by("modify", stimulus.modify, concerns::motion, StepsForm());
  field("interpolation", stimulus.interpolation, concerns::motion);
}

void fields_of(auto&& field, MaybeConst<Person> auto& person) {
  field("name", person.name, concerns::motion | concerns::picture);
  auto& motion = person.stated ? *person.stated : person.motion;
  motion_fields(field, motion);
  field("on_fault", motion.on_fault, concerns::motion, fault_words);
  field("place", person.place, concerns::picture);
  field("start", person.start, concerns::picture);
  field.group("look", [&](auto& look) {
    look.by("figure", person.figure, concerns::picture, PersonFigureForm());
    look.by("face", person.face, concerns::picture, PersonFaceForm());
    look.by("hands", person.hands, concerns::picture, PersonHandsForm());
    look("colour", person.colour, concerns::picture);
  });
}

void fields_of(auto&& field, MaybeConst<Stimulus> auto& stimulus) {
  field("id", stimulus.id, concerns::motion | concerns::required);
  field("role", stimulus.role, concerns::picture, role_words);
  field("foil", stimulus.foil, concerns::motion);
  field("on_fault", stimulus.on_fault, concerns::motion, fault_words);
  field("audio", stimulus.audio, concerns::shown);
  field("look", stimulus.look, concerns::picture);
  field("output", stimulus.output, concerns::nothing);
  field.by("factors", stimulus.factors, concerns::page, FactorsForm());
  field.by("levels", stimulus.level, concerns::nothing, StimulusLevelForm());
  field("regression", stimulus.regression, concerns::nothing);
  if (stimulus.foil) return;
  motion_fields(field, stimulus);
  field.each("people", stimulus.people, concerns::motion | concerns::picture,
             [&] { return plain_person(stimulus); });
  field("swap", stimulus.swap, concerns::motion | concerns::picture);
}

/// Whether a stimulus is blended from examples, and not taken from a file or walked along a path;
/// false for one with several people.
inline bool is_blend(const Stimulus& stimulus) {
  return !stimulus.clip && !stimulus.walk && stimulus.people.empty();
}

}  // namespace mien::pipeline
