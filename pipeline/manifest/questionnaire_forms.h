#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/local_texts.h"
#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

/// The stimuli that are rated: those named, or those that have, for each factor in `levels`, one of
/// the given levels; all if neither is given.
struct StimulusChoice {
  std::vector<std::string> ids;
  std::vector<std::pair<std::string, std::vector<std::string>>> levels;
};

/// `stimuli: [a, b]`, or `stimuli: {made: [acted, modified]}`.
struct StimulusChoiceForm {
  static void read(const DocumentValue& given, StimulusChoice& choice);
  static nlohmann::ordered_json write(const StimulusChoice& choice, const WritingOptions& how);
};

/// The scales that are asked.
struct ScaleChoice {
  bool all = false;       ///< all scales of the study or of the file
  bool emotions = false;  ///< the six scales of the emotion thesis
  std::vector<std::string> ids;
  /// File of the questionnaire's own scales; empty: the study's scales.
  std::filesystem::path file;
  ScaleSet own = {};  ///< content of that file, once the manifest has been read
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

/// Possible answers: ids and what is displayed.
using DisplayedChoices = std::vector<std::pair<std::string, LocalText>>;

/// `choices: [sad, happy]`, `choices: {sad: 悲しい, happy: 嬉しい}`, or
/// `choices: {sad: {en: sad, de: traurig}, …}`.
struct ChoicesForm {
  static void read(const DocumentValue& given, DisplayedChoices& choices);
  static nlohmann::ordered_json write(const DisplayedChoices& choices, const WritingOptions& how);
};

/// The type of answer to a question about the participant.
struct AnswerChoice {
  bool is_number = false;
  /// Possible answers; empty: a text or a number. Those in the first language offered are
  /// recorded, whichever language is displayed.
  LocalWords choices;
};

/// `answer: number`, `answer: text`, `answer: [one, other]`, or
/// `answer: {en: [one, other], de: [einer, anderer]}`.
struct AnswerChoiceForm {
  static void read(const DocumentValue& given, AnswerChoice& answer);
  static nlohmann::ordered_json write(const AnswerChoice& answer, const WritingOptions& how);
};

/// The order in which a participant sees the stimuli.
struct TrialOrder {
  enum class Kind { full, fixed, latin, blocked };

  Kind kind = Kind::full;
  std::string factor;  ///< factor whose levels form the blocks; empty for other kinds
};

/// `order: latin`, or `order: {blocked: actor}`.
struct TrialOrderForm {
  static void read(const DocumentValue& given, TrialOrder& order);
  static nlohmann::ordered_json write(const TrialOrder& order, const WritingOptions& how);
  static void walk(auto& names) { names.add("blocked"); }
};

/// The width of each video on the screen.
struct DisplaySize {
  enum class Kind { window, native, cm, degrees };

  Kind kind = Kind::window;  ///< as large as the window allows
  double amount = 0.0;       ///< for cm and degrees
};

/// `size: window`, `size: native`, `size: {cm: 15}`, or `size: {degrees: 12}`.
struct DisplaySizeForm {
  static void read(const DocumentValue& given, DisplaySize& size);
  static nlohmann::ordered_json write(const DisplaySize& size, const WritingOptions& how);
  static void walk(auto& names) {
    names.add("cm");
    names.add("degrees");
  }
};

/// The number of times that a video may be replayed. Replays are always counted.
struct Replays {
  std::optional<int> most;  ///< 0: none; unset: unlimited
};

/// `replays: counted`, `replays: none`, or `replays: 3`.
struct ReplaysForm {
  static void read(const DocumentValue& given, Replays& replays);
  static nlohmann::ordered_json write(const Replays& replays, const WritingOptions& how);
};

}  // namespace mien::pipeline
