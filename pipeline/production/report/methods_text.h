#pragma once

#include <string>

#include "pipeline/production/report/prose.h"

namespace mien::pipeline {

/// A text of sentences and paragraphs that cites as pandoc reads it.
class MethodsText {
 public:
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
