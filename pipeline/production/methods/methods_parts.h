#pragma once

#include <string>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/style_step.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Builds a text about a study from sentences and paragraphs, with citations in pandoc's syntax.
class MethodsText {
 public:
  MethodsText(const Manifest& of, Motions& made) : manifest(of), motions(made) {}

  const Manifest& manifest;
  Motions& motions;

  void say(const std::string& sentence);
  /// Appends a text of the author as a quotation of its own.
  void quote(const std::string& text);
  void end_paragraph();

  /// Begins a section with paragraphs of its own.
  void begin_section(const std::string& heading);

  /// Returns a citation, " [@rose1998; @sloan2001]", and records the cited works. Works that cannot
  /// be cited as they are known (Reference::missing) are named by a number, " (source 1 above)",
  /// under which `text` lists them.
  std::string cite(const Names& keys);

  /// The text. Works to be completed before they can be cited are listed once, at its beginning.
  std::string text() const;
  const Names& cited() const { return cited_; }

 private:
  std::string text_ = "# Stimuli\n\n";
  Names cited_;
  Names incomplete_;
};

// The parts of the methods section. A part that does not apply to the study writes nothing.

/// The examples and their ratings.
void describe_examples(MethodsText& out);

/// The licences and sources of the recordings, as far as they are stated, and how well bodies fit
/// recorded points.
void describe_recordings(MethodsText& out);

/// The blending of examples, the deviations from the requested values, and the held parameters.
void describe_blends(MethodsText& out);

/// The walks along paths: what the walkers do, how long and how far, and where their mood changes.
void describe_paths(MethodsText& out);

/// The modifications of motions, and the foils.
void describe_modifications(MethodsText& out);

/// The presentation of the motions, the properties equalized across films, and the distances
/// between motions.
void describe_pictures(MethodsText& out);

/// The sounds of the videos: sources, exchange, lengths, encoding and loudness.
void describe_sounds(MethodsText& out);

/// Every setting of films and of the interpolation of their motions that differs from its default,
/// except those that other sentences state for all films; also the number and size of the dots of
/// point-light figures, and the number of markers with the share of their gaps.
void describe_settings(MethodsText& out);

/// The settings for reading the examples from a folder, as far as they differ from their defaults.
void describe_example_settings(MethodsText& out);

/// The settings of a matching experiment that differ from their defaults: the order of guesses and
/// matches, and whether the examples are played beside the task.
void describe_matching_settings(MethodsText& out);

/// An adaptive experiment: method, words, dimensions and chains.
void describe_adaptive(MethodsText& out);

/// Participants: number, recruitment, screening, consent, questions about them, and language.
void describe_participants(MethodsText& out);

/// The trials of the questionnaire: task, presentation and order.
void describe_trials(MethodsText& out);

/// What participants are asked in an adaptive trial, as a sentence without its full stop.
std::string adaptive_task_text(const Manifest& manifest);

/// The levels of adaptive trials, the rule by which they are chosen, the tracks and their ends.
void describe_levels(MethodsText& out);

/// Level of significance, correction, and exclusion by attention checks.
void describe_tests(MethodsText& out);

/// The factors and contrasts by which answers to the questionnaire are analysed, if stated, and
/// what the report computes in any case.
void describe_factorial_plan(MethodsText& out);

/// The quality rules by which answers to the questionnaire are flagged.
void describe_quality_rules(MethodsText& out);

/// The analysis plan as the manifest states it in words, as a quotation.
void describe_stated_plan(MethodsText& out);

/// The description of an interpolation method and the keys of its references.
struct MethodWords {
  motion::InterpolationMethod method;
  std::string words;
  Names sources;
};

/// Returns the description and references of that method.
MethodWords words_of(motion::InterpolationMethod method);

/// Returns the key of the reference for a method of style transfer.
std::string source_of(StyleMethod method);

}  // namespace mien::pipeline
