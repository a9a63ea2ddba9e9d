#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// A text for participants, as it stands in the manifest or in a file. Once a manifest has been
/// read, `text` is filled in either case.
struct TextSource {
  std::string text;
  std::filesystem::path file;  ///< resolved; empty where the manifest says it itself

  bool empty() const { return text.empty(); }
};

/// `consent: |` …, or `consent: {file: consent.txt}`.
struct TextForm {
  static void read(const DocumentValue& given, TextSource& source);
  static nlohmann::ordered_json write(const TextSource& source, const WritingOptions& how);
  static void walk(auto& names) { names.add("file"); }
};

/// Which stimuli are asked about: those named, or those whose levels are among the given ones in
/// each factor; all when it says neither.
struct StimulusChoice {
  std::vector<std::string> ids;
  std::vector<std::pair<std::string, std::vector<std::string>>> levels;
};

/// `stimuli: [a, b]`, or `stimuli: {made: [acted, modified]}`.
struct StimulusChoiceForm {
  static void read(const DocumentValue& given, StimulusChoice& choice);
  static nlohmann::ordered_json write(const StimulusChoice& choice, const WritingOptions& how);
};

/// Which scales are asked.
struct ScaleChoice {
  bool all = false;       ///< all of the study's, or of the file's
  bool emotions = false;  ///< the six of the emotion thesis
  std::vector<std::string> ids;
  std::filesystem::path file;  ///< scales of the questionnaire's own; empty: the study's
  ScaleSet own = {};           ///< what that file says, once the manifest has been read
};

/// `scales: [sad-happy]`, `scales: all`, `scales: emotions`, or `scales: {file: …, ask: […]}`.
struct ScaleChoiceForm {
  static void read(const DocumentValue& given, ScaleChoice& choice);
  static nlohmann::ordered_json write(const ScaleChoice& choice, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("file");
    names.add("ask");
  }
};

/// `choices: [sad, happy]`, or `choices: {sad: 悲しい, happy: 嬉しい}`.
struct ChoicesForm {
  static void read(const DocumentValue& given,
                   std::vector<std::pair<std::string, std::string>>& choices);
  static nlohmann::ordered_json write(
      const std::vector<std::pair<std::string, std::string>>& choices, const WritingOptions& how);
};

/// What answers a question about the participant.
struct AnswerChoice {
  bool is_number = false;
  std::vector<std::string> choices;  ///< one of these; empty: a text, or a number
};

/// `answer: number`, `answer: text`, or `answer: [one, other]`.
struct AnswerChoiceForm {
  static void read(const DocumentValue& given, AnswerChoice& answer);
  static nlohmann::ordered_json write(const AnswerChoice& answer, const WritingOptions& how);
};

/// In which order a participant sees the stimuli.
struct TrialOrder {
  enum class Kind { full, fixed, latin, blocked };

  Kind kind = Kind::full;
  std::string factor;  ///< whose levels are the blocks; empty for others
};

/// `order: latin`, or `order: {blocked: actor}`.
struct TrialOrderForm {
  static void read(const DocumentValue& given, TrialOrder& order);
  static nlohmann::ordered_json write(const TrialOrder& order, const WritingOptions& how);
  static void walk(auto& names) { names.add("blocked"); }
};

/// How often a video may be seen again; however often, it is counted.
struct Replays {
  std::optional<int> most;  ///< 0: never again; unset: as often as is liked
};

/// `replays: counted`, `replays: none`, or `replays: 3`.
struct ReplaysForm {
  static void read(const DocumentValue& given, Replays& replays);
  static nlohmann::ordered_json write(const Replays& replays, const WritingOptions& how);
};

}  // namespace mien::pipeline
