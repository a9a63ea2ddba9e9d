#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A questionnaire with all media that are shown to participants.
struct PreparedQuestionnaire {
  Manifest manifest;
  std::filesystem::path folder;  ///< folder of the study
  std::vector<SessionPlan> plans;
  MediaFiles media;
};

/// Reads the manifest, runs the missing tasks of the stimuli that the questionnaire shows, like
/// `mien run`, and plans the sessions. Does not print the warnings of the manifest: the caller has
/// already read it by participants_manifest, which prints them. Throws Error if there is no
/// questionnaire, Error or std::runtime_error if a task fails, and Interrupted if stopped.
PreparedQuestionnaire prepared_questionnaire(const ProductionArguments& arguments,
                                             const Console& console);

/// The options that select the study and control its run: the manifest, --out, --quality and
/// --jobs. The short option -o is reserved for the command itself.
std::vector<CommandOption> questionnaire_options(ProductionArguments& arguments);

}  // namespace mien::pipeline
