#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
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

}  // namespace mien::pipeline
