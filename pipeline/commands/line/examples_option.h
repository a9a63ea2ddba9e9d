#pragma once

#include <string>

#include "pipeline/commands/line/recording_options.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The examples of --examples (`parse_examples`), whose files are read as the arguments say. Throws
/// Error, also if they apply to a built-in set.
Examples examples_of(const std::string& examples, const RecordingArguments& arguments);

/// Throws Error if there are arguments, since `what` does not take them: "a manifest".
void refuse_recording_options(const RecordingArguments& arguments, const std::string& what,
                              const std::string& remedy);

}  // namespace mien::pipeline
