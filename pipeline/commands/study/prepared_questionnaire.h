#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A questionnaire whose study is complete: all media shown to participants exist.
struct PreparedQuestionnaire {
  Manifest manifest;
  std::filesystem::path folder;  ///< folder of the study
  std::vector<SessionPlan> plans;
  MediaFiles media;
};

/// Reads the manifest, runs the missing tasks of its study like `mien run`, and plans the sessions.
/// Warnings of the manifest are not printed again after participants_manifest. Throws Error if
/// there is no questionnaire or a task fails, and Interrupted if stopped.
PreparedQuestionnaire prepared_questionnaire(const ProductionArguments& arguments,
                                             const Console& console);

/// The options that select the study and control its run: the manifest, --out, --quality and
/// --jobs. The short option -o is reserved for the command itself.
std::vector<CommandOption> questionnaire_options(ProductionArguments& arguments);

}  // namespace mien::pipeline
