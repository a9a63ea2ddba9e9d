#pragma once

#include <string>
#include <vector>

namespace mien::pipeline {

struct Manifest;

enum class ReportTense {
  present,  ///< of a plan
  past,     ///< of the methods section of a paper
};

/// What the report of a study with this questionnaire computes without being asked to, in sentences
/// without their full stops: of continuous trials, mean traces, changes between moods and
/// agreement; of ratings, the analysis of variance by the factors of the stimuli, unless the
/// analysis plan states one, and the comparisons of all pairs of levels; of all trials, what
/// becomes of incomplete answers. The manifest must have a questionnaire.
std::vector<std::string> reported_analyses(const Manifest& manifest, ReportTense tense);

}  // namespace mien::pipeline
