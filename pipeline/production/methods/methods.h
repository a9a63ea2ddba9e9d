#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// How a study's stimuli were made, for the methods section of a paper: what was used, by which
/// method, with which numbers. Only what this study uses is stated.
struct Methods {
  std::string markdown;  ///< paragraphs that cite as pandoc reads it: [@rose1998; @sloan2001]
  std::string bibtex;    ///< the entries of all that is cited
};

Methods methods_of(const Manifest& manifest, Motions& motions);

/// The paragraphs as HTML, works cited by author and year.
std::string methods_html(const std::string& markdown);

}  // namespace mien::pipeline
