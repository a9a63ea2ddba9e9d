#include <map>
#include <optional>
#include <string>
#include <utility>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/animation_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/checks/take_checks.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

namespace {

class StepChecker : FaultList {
 public:
  using FaultList::FaultList;
  using FaultList::take;

  void check_step(const ModificationStep& step) {
    check_style(step);
    if (step.edit.names("paths") && step.edit.names("gains")) {
      add(member_path(step.path, "gains"), "paths already determines the band gains",
          "give paths or gains");
    }
    check_hands(step);
    check_tempo(step);
    if (step.edit.pose) {
      check_pose(member_path(step.path, "pose.neutral"), step.edit.pose->neutral);
      check_pose(member_path(step.path, "pose.posed"), step.edit.pose->posed);
    } else if (step.pose) {
      check_recipe_pose(step, step.pose->neutral);
      check_recipe_pose(step, step.pose->posed);
    }
  }

  void names(const Stimulus& stimulus, const Vocabulary& vocabulary) {
    for (const ModificationStep& step : stimulus.modify) {
      if (step.style) check_style_examples(step, vocabulary);
      if (!step.edit.pose) continue;
      const std::string path = member_path(step.path, "pose");
      for (const auto& [key, pose] : {std::pair("neutral", step.edit.pose->neutral),
                                      std::pair("posed", step.edit.pose->posed)}) {
        if (pose.example.empty()) continue;
        check_known_name(member_path(path, key), pose.example, "example", vocabulary.examples);
      }
    }
  }

 private:
  /// Keys of a step, each with the older method that it is for; none for all of them.
  void check_style(const ModificationStep& step) {
    static const std::map<std::string, std::optional<StyleMethod>> keys = {
        {"neutral", {}},
        {"styled", {}},
        {"harmonics", StyleMethod::unuma},
        {"order", StyleMethod::hsu},
        {"inputs", StyleMethod::hsu},
        {"components", StyleMethod::shapiro},
        {"swap", StyleMethod::shapiro}};
    for (const auto& [key, method] : keys) {
      const std::string path = member_path(step.path, key);
      const bool is_for = step.style && (!method || step.style->method == *method);
      if (!was_given(path) || is_for) continue;
      add(path,
          "only " + (method ? "method: " + std::string(name_of(*method)) : "a method") +
              " has this key",
          "omit it");
    }
    if (!step.style) return;
    for (const char* key : {"neutral", "styled"}) {
      if (was_given(member_path(step.path, key))) continue;
      add(member_path(step.path, "method"),
          "a style is the difference between two examples, but " + std::string(key) + " is missing",
          "add neutral: and styled:");
    }
    if (!was_given("examples")) {
      add(member_path(step.path, "method"), "there are no examples for a style", "add examples:");
    }
    for (const char* key :
         {"emotion",   "paths",       "gains",     "signal",      "acceleration", "acceleration_at",
          "limbs",     "posture",     "pose",      "step_width",  "step_length",  "sway",
          "arm_swing", "trunk_swing", "gesture",   "range",       "tempo",        "gravity",
          "stiffness", "weight",      "variation", "soft_limits", "freeze",       "drives",
          "keys",      "constraints", "ends",      "hands"}) {
      if (!was_given(member_path(step.path, key))) continue;
      add(member_path(step.path, key), "a step with a method has no other changes",
          "make a list of two steps");
    }
  }

  void check_hands(const ModificationStep& step) {
    const motion::Modification& m = step.modification;
    const bool changes_paths = m.gains || m.paths != 1.0;
    if (step.style || m.hands == motion::FingerPaths::kept || changes_paths) return;
    add(member_path(step.path, "hands"),
        "fingers are scaled with the paths of the body, but these stay as they are",
        "add paths: or gains:, or omit it");
  }

  void check_tempo(const ModificationStep& step) {
    const motion::TempoFault fault = motion::fault_of(step.edit.values.tempo);
    if (fault.wrong.empty()) return;
    add(path_of(fault, member_path(step.path, "tempo")), fault.wrong, fault.remedy);
  }

  void check_pose(const std::string& path, const PoseSource& pose) {
    if (!pose.file.empty())
      check_file(path, pose.file, "the name of an example or a motion file",
                 motion::max_recording_bytes);
    check_take(member_path(path, "take"), pose.file, read_options(pose.how), *this);
    check_body_model(member_path(path, "body_model"), pose.file, read_options(pose.how), *this);
    if (!pose.example.empty() && !pose.how.take.empty()) {
      add(member_path(path, "take"),
          motion::in_quotes(pose.example) + " is an example with one motion",
          "omit take, or name a motion file");
    }
    if (!pose.example.empty() && !was_given("examples")) {
      add(path, "there are no examples to take " + motion::in_quotes(pose.example) + " from",
          "add examples:, or name a motion file");
    }
  }

  /// Its paths are taken from the folder of the recipes.
  void check_recipe_pose(const ModificationStep& step, const PoseSource& pose) {
    const std::string path = member_path(step.path, "emotion");
    const std::string problem =
        pose.file.empty() ? "" : motion::read_error(pose.file, motion::max_recording_bytes);
    if (!problem.empty()) {
      add(path, "its recipe uses a pose of " + pose.file.string() + ": " + problem,
          "correct the recipe; paths are relative to its file's folder");
    }
    if (!pose.example.empty() && !was_given("examples")) {
      add(path,
          "its recipe uses a pose of " + motion::in_quotes(pose.example) +
              ", but there are no examples",
          "add examples:");
    }
  }

  void check_style_examples(const ModificationStep& step, const Vocabulary& vocabulary) {
    for (const auto& [key, name] :
         {std::pair("neutral", step.style->neutral), std::pair("styled", step.style->styled)}) {
      if (name.empty()) continue;
      check_known_name(member_path(step.path, key), name, "example", vocabulary.examples);
    }
  }
};

}  // namespace

std::vector<Fault> check_modifications(const Manifest& manifest) {
  StepChecker checker(manifest.places);
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (stimulus->foil) continue;
    for (const ModificationStep& step : stimulus->modify) checker.check_step(step);
  }
  std::vector<Fault> faults = checker.take();
  for (Fault& fault : check_animation(manifest)) faults.push_back(std::move(fault));
  return faults;
}

std::vector<Fault> check_modification_names(const Manifest& manifest,
                                            const Vocabulary& vocabulary) {
  StepChecker checker(manifest.places);
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (!stimulus->foil) checker.names(*stimulus, vocabulary);
  }
  return checker.take();
}

}  // namespace mien::pipeline
