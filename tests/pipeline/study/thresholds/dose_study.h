#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::test {

/// A study of two actors (a, b) with seven stimuli each, a0 … a6 and b0 … b6, of the factors dose
/// (0, 0.5, …, 3), dots (70, 60, …, 10), word ("w0" …) and actor, and with the members of a
/// questionnaire that are given. The manifest's text; the questionnaire is in line 5.
std::string dose_study_text(const std::string& members);

/// The same as a manifest. All must be right.
pipeline::Manifest dose_study(const std::string& members);

/// "participants: 3, question: Which one, trials: two_interval, adaptive: {factor: dose, …}"
std::string adaptive_members(const std::string& form, const std::string& more);

}  // namespace mien::test
