#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The methods section of a paper about a study's stimuli: sources, methods and parameters. Only
/// what the study uses is stated.
struct Methods {
  std::string markdown;  ///< paragraphs with citations in pandoc's syntax: [@rose1998; @sloan2001]
  std::string bibtex;    ///< BibTeX entries of all cited works
};

Methods methods_of(const Manifest& manifest, Motions& motions);

/// Returns the sections of the methods on participants, procedure and analysis, for a
/// preregistration. The manifest must have a questionnaire.
Methods procedure_of(const Manifest& manifest);

/// Returns the paragraphs as HTML, with works cited by author and year.
std::string methods_html(const std::string& markdown);

}  // namespace mien::pipeline
