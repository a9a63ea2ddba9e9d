#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/questionnaire/experiment/media.h"
#include "pipeline/study/questionnaire/session_plan.h"

namespace mien::pipeline {

/// A questionnaire whose study has been made: everything that participants see is there.
struct MadeQuestionnaire {
  Manifest manifest;
  std::filesystem::path folder;  ///< of the study
  std::vector<SessionPlan> plans;
  MediaFiles media;
};

/// Reads the manifest, makes what is missing of its study, as `mien run` would, and lays out the
/// sessions. Throws Error where there is no questionnaire or the study cannot be made, and
/// Interrupted.
MadeQuestionnaire made_questionnaire(const ProductionArguments& arguments, const Console& console);

/// The options that say which study it is and how it is made: the manifest, --out, --quality and
/// --jobs. -o is left to the command.
std::vector<CommandOption> questionnaire_options(ProductionArguments& arguments);

}  // namespace mien::pipeline
