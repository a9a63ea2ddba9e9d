#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/examples/make_example.h"
#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/ratings/answers/expectation.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/manifest/recording_choice.h"

namespace mien::pipeline {

struct Examples;

/// `labels:` of a folder: a rule or a map.
struct LabelsForm {
  static void read(const DocumentValue& given, Examples& examples);
  static nlohmann::ordered_json write(const Examples& examples, const WritingOptions& how);
};

/// The motions that are blended: a built-in set or the files of a folder.
struct Examples {
  enum class Labels { from_name, file_name };

  std::string builtin;           ///< "walks-10" of "builtin:walks-10"; empty for a folder
  std::filesystem::path folder;  ///< resolved
  std::string include = "*";     ///< glob on file names
  std::string exclude;           ///< glob on file names; empty excludes nothing
  RecordingChoice how;           ///< which motions of the files
  motion::CycleChoice cycle = motion::CycleChoice::automatic;
  /// Keytimes set manually: file stem → keytimes, seconds.
  std::vector<std::pair<std::string, std::vector<double>>> keytimes;
  /// Whether the motions are retargeted to one body and aligned in time; otherwise each keeps its
  /// own body and keytimes.
  bool blendable = true;
  /// Names of the examples: the distinguishing part of the file name, or all of it.
  Labels labels = Labels::from_name;
  std::vector<std::pair<std::string, std::string>> given_labels;  ///< file stem → label
};

inline constexpr Words<motion::CycleChoice> cycle_words = {
    {"auto", motion::CycleChoice::automatic},
    {"whole", motion::CycleChoice::whole},
    {"start-peak-end", motion::CycleChoice::start_peak_end}};

/// The fields of a folder of examples.
void fields_of(auto&& field, MaybeConst<Examples> auto& examples) {
  field("folder", examples.folder, concerns::repertoire);
  field("include", examples.include, concerns::repertoire);
  field("exclude", examples.exclude, concerns::repertoire);
  recording_fields(field, examples.how, concerns::repertoire);
  field("cycle", examples.cycle, concerns::repertoire, cycle_words);
  field("blend", examples.blendable, concerns::repertoire);
  field("keytimes", examples.keytimes, concerns::repertoire);
  field.by("labels", examples, concerns::repertoire, LabelsForm());
}

/// `set:`: a built-in set or a folder.
struct ExampleSetForm {
  static void read(const DocumentValue& given, Examples& examples);
  static nlohmann::ordered_json write(const Examples& examples, const WritingOptions& how);
  static void walk(auto& names) { names.template of<Examples>(); }
};

/// Ratings of the examples by participants.
struct Ratings {
  enum class Source { none, builtin, simulated, file };

  Source source = Source::none;
  std::filesystem::path file;              ///< CSV of answers or of means, resolved
  int raters = 14;                         ///< number of simulated raters
  bool ignore_unknown = false;             ///< ignore answers about unknown stimuli or scales
  std::vector<Expectation> expected = {};  ///< expected order of the examples (manipulation checks)
};

inline constexpr Words<Ratings::Source> ratings_words = {{"none", Ratings::Source::none},
                                                         {"builtin", Ratings::Source::builtin},
                                                         {"simulated", Ratings::Source::simulated}};

inline constexpr Words<bool> unknown_words = {{"error", false}, {"ignore", true}};

/// `ratings:`: a keyword or a file.
struct RatingsForm {
  static void read(const DocumentValue& given, Ratings& ratings);
  static nlohmann::ordered_json write(const Ratings& ratings, const WritingOptions& how);
};

void fields_of(auto&& field, MaybeConst<Expectation> auto& expected) {
  field("parameter", expected.parameter, concerns::page | concerns::required);
  field("order", expected.order, concerns::page | concerns::required);
}

/// The scales of the ratings: the 41 built-in adjective pairs or a file.
struct ScalesSource {
  std::filesystem::path file;  ///< empty: built-in
  ScaleSet set;                ///< content of the file, once it has been read
};

/// Reads the scales of a file. Throws as read_scales does.
ScalesSource scales_in(const std::filesystem::path& file);

/// Returns the scales of a source.
ScaleSet scales_of(const ScalesSource& source);

/// `scales:`: `builtin` or a file.
struct ScalesForm {
  static void read(const DocumentValue& given, ScalesSource& scales);
  static nlohmann::ordered_json write(const ScalesSource& scales, const WritingOptions& how);
};

}  // namespace mien::pipeline
