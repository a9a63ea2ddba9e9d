#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// Whether participants are asked anything about themselves: demographic or screening questions.
bool asks_about_participants(const Manifest& manifest);

/// The table of simulated participants (participants.csv) who finished the sessions: answers to the
/// questions about them, in the order of the pages, with a column `simulated` that is 1. Answers
/// are those that the screening accepts: each choice equally often, whole numbers uniformly between
/// the accepted bounds (otherwise from 18 to 65, with an open bound 47 away from the stated one),
/// and the word "simulated" for free text. They do not depend on the answers to trials.
/// Deterministic in the seed of each plan.
std::string simulated_people_csv(const Manifest& manifest, const std::vector<SessionPlan>& plans);

}  // namespace mien::pipeline
