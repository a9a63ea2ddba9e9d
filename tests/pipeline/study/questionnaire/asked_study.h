#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"

namespace mien::test {

/// A study of so many stimuli a1, b2, c3, a4 …, with the factors actor (a, b, c in turn) and
/// emotion (sad, happy, angry, calm, four after four), and with the members of a questionnaire that
/// are given, as "order: latin, warm_up: 2". All must be right.
std::string asked_study_text(int stimuli, const std::string& members);
pipeline::Manifest asked_study(int stimuli, const std::string& members);

}  // namespace mien::test
