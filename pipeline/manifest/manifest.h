#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/manifest/adaptive.h"
#include "pipeline/manifest/design.h"
#include "pipeline/manifest/examples.h"
#include "pipeline/manifest/matching.h"
#include "pipeline/manifest/output.h"
#include "pipeline/manifest/questionnaire.h"
#include "pipeline/manifest/sheet.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// The source of the recipes for emotions.
struct RecipesSource {
  std::string name = "builtin";  ///< built-in ones (builtin_recipes_text), or the file
  std::filesystem::path file;    ///< resolved; empty for built-in recipes
};

/// `recipes:`: the name of built-in ones, or a file.
struct RecipesForm {
  static void read(const DocumentValue& given, RecipesSource& recipes);
  static nlohmann::ordered_json write(const RecipesSource& recipes, const WritingOptions& how);
};

/// The stimuli that share one equalized value: those of the whole study, or those with the same
/// kind of figure.
enum class EqualizeGroup { study, figure };

inline constexpr Words<EqualizeGroup> equalize_group_words = {{"study", EqualizeGroup::study},
                                                              {"figure", EqualizeGroup::figure}};

/// Properties of films that are equalized across stimuli; none by default.
struct Equalize {
  std::optional<EqualizeGroup> luminance;  ///< mean luminance of the films, equalized by exposure
  /// Height of the figures in pixels, equalized by the distance of the camera.
  std::optional<EqualizeGroup> size;
  std::optional<EqualizeGroup> place;  ///< position of the figures in the picture, equalized by
                                       ///< shifting the picture's centre
  bool duration = false;               ///< number of frames, set to that of the shortest stimulus
  /// Integrated loudness of the sounds by EBU R 128, LUFS, equalized by gain.
  std::optional<double> loudness;

  friend bool operator==(const Equalize&, const Equalize&) = default;
};

/// `luminance: true`, or `luminance: {by: figure}`.
struct EqualizeGroupForm {
  static void read(const DocumentValue& given, std::optional<EqualizeGroup>& group_by);
  static nlohmann::ordered_json write(const std::optional<EqualizeGroup>& group_by,
                                      const WritingOptions&);
  static void walk(auto& names) { names.add("by"); }
};

void fields_of(auto&& field, MaybeConst<Equalize> auto& equalize) {
  field.by("luminance", equalize.luminance, concerns::picture, EqualizeGroupForm());
  field.by("size", equalize.size, concerns::picture, EqualizeGroupForm());
  field.by("place", equalize.place, concerns::picture, EqualizeGroupForm());
  field("duration", equalize.duration, concerns::picture);
  field.by("loudness", equalize.loudness, concerns::shown, LoudnessForm());
}

/// `equalize:`: an array of names or a map.
struct EqualizeForm {
  static void read(const DocumentValue& given, Equalize& equalize);
  static nlohmann::ordered_json write(const Equalize& equalize, const WritingOptions& how);
  static void walk(auto& names) { names.template of<Equalize>(); }
};

/// Returns the groups of stimuli within which a property is equalized, in the order of the
/// manifest.
std::vector<std::vector<const Stimulus*>> equalized_groups(const std::vector<Stimulus>& stimuli,
                                                           EqualizeGroup group_by);

/// The language of the names of parameters, features and joints on sheets and in the report; those
/// without a Japanese name are named in English.
enum class NameLanguage {
  study,  ///< Japanese if that is the first language of the pages for participants, else English
  english,
  japanese,
  both
};

inline constexpr Words<NameLanguage> name_language_words = {{"study", NameLanguage::study},
                                                            {"en", NameLanguage::english},
                                                            {"ja", NameLanguage::japanese},
                                                            {"both", NameLanguage::both}};

/// A manifest with defaults filled in and overrides merged.
struct Manifest {
  std::filesystem::path file;
  std::string command;  ///< command line that makes the study, reduced to what affects the
                        ///< artifacts; set by Production, or read from a provenance.json
  int version = 1;
  std::string study;
  std::uint64_t seed = 0;
  Examples examples;
  Ratings ratings;
  ScalesSource scales;
  Look look;
  Output output;
  Interpolation interpolation;
  RecipesSource recipes;
  OnFault on_fault = OnFault::warn;
  Equalize equalize;
  RegressionLimits regression;
  Design design;
  NameLanguage names = NameLanguage::study;
  std::vector<Stimulus> stimuli;
  std::optional<Mismatch> mismatch;
  std::vector<Overlay> overlays;
  std::vector<Sheet> sheets;
  std::optional<Questionnaire> questionnaire;
  std::optional<Matching> matching;
  std::optional<Adaptive> adaptive;
  Places places;
  /// For each stimulus, the place among those of the document of the one that it was made from, if
  /// any of them has `levels:`; otherwise empty.
  std::vector<std::size_t> origins;
  std::vector<Fault> renamed;  ///< warnings about keys with deprecated names
};

/// The language of names with NameLanguage::study resolved.
NameLanguage name_language(const Manifest& manifest);

/// Return a stimulus or an overlay that has only the manifest's defaults.
Stimulus plain_stimulus(const Manifest& manifest);
Overlay plain_overlay(const Manifest& manifest);

void fields_of(auto&& field, MaybeConst<Manifest> auto& manifest) {
  field("mien", manifest.version, concerns::required);
  field("study", manifest.study, concerns::page | concerns::required);
  field("seed", manifest.seed, concerns::repertoire | concerns::motion | concerns::picture);
  field.group("examples", [&](auto& examples) {
    examples.by("set", manifest.examples, concerns::repertoire, ExampleSetForm());
    examples.by("ratings", manifest.ratings, concerns::repertoire | concerns::required,
                RatingsForm());
    examples.by("scales", manifest.scales, concerns::repertoire, ScalesForm());
    examples("unknown", manifest.ratings.ignore_unknown, concerns::repertoire, unknown_words);
    examples("raters", manifest.ratings.raters, concerns::repertoire);
    examples("expect", manifest.ratings.expected, concerns::page);
  });
  field("look", manifest.look, concerns::picture);
  field("output", manifest.output, concerns::nothing);
  field("interpolation", manifest.interpolation, concerns::motion);
  field.by("recipes", manifest.recipes, concerns::motion, RecipesForm());
  field("on_fault", manifest.on_fault, concerns::motion, fault_words);
  field.by("equalize", manifest.equalize, concerns::picture, EqualizeForm());
  field("regression", manifest.regression, concerns::nothing);
  field("design", manifest.design, concerns::page);
  field("names", manifest.names, concerns::nothing, name_language_words);
  field.each("stimuli", manifest.stimuli, concerns::nothing,
             [&] { return plain_stimulus(manifest); });
  field("mismatch", manifest.mismatch, concerns::nothing);
  field.each("overlays", manifest.overlays, concerns::nothing,
             [&] { return plain_overlay(manifest); });
  field.each("sheets", manifest.sheets, concerns::page, [] { return Sheet(); });
  field("questionnaire", manifest.questionnaire, concerns::nothing);
  field("matching", manifest.matching, concerns::nothing);
  field("adaptive", manifest.adaptive, concerns::nothing);
}

/// Returns everything that is filmed: the stimuli, then the overlays.
std::vector<const Stimulus*> films_of(const Manifest& manifest);

}  // namespace mien::pipeline
