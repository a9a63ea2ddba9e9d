#pragma once

#include <string>

#include "motion/interpolation/interpolation_options.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/style_step.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// A text of sentences and paragraphs about a study that cites as pandoc reads it.
class MethodsText {
 public:
  MethodsText(const Manifest& of, Motions& made) : manifest(of), motions(made) {}

  const Manifest& manifest;
  Motions& motions;

  void say(const std::string& sentence);
  void end_paragraph();

  /// " [@rose1998; @sloan2001]", and notes the works.
  std::string cite(const Names& keys);

  const std::string& text() const { return text_; }
  const Names& cited() const { return cited_; }

 private:
  std::string text_ = "# Stimuli\n\n";
  Names cited_;
};

// The parts of the methods section. A part that has no subject in the study writes nothing.

/// What the motions were made from, and what people thought of it.
void describe_examples(MethodsText& out);

/// How examples became motions, how near these came to what was requested, and what was held.
void describe_blends(MethodsText& out);

/// What was done to motions afterwards, and which of them are foils.
void describe_modifications(MethodsText& out);

/// How the motions were shown, what films have in common, and how far motions are from each other.
void describe_pictures(MethodsText& out);

/// Every setting of films and of the interpolation of their motions that differs from its default,
/// without those that other sentences give for all films; and number and size of point lights.
void describe_settings(MethodsText& out);

/// The settings of the folder of examples that differ from their defaults.
void describe_example_settings(MethodsText& out);

/// The order of guesses and matches of a matching experiment and the films beside them, where these
/// differ from their defaults.
void describe_matching_settings(MethodsText& out);

/// A way of interpolation in words, and the keys of the references that it is from.
struct MethodWords {
  motion::InterpolationMethod method;
  std::string words;
  Names sources;
};

/// The words and sources of that method.
MethodWords words_of(motion::InterpolationMethod method);

/// The key of the reference that an older method is from.
std::string source_of(StyleMethod method);

}  // namespace mien::pipeline
