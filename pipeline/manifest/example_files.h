#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/examples/example_set.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/impressions.h"

namespace mien::pipeline {

/// Returns the manifest's folder of examples as a type of the motion module.
motion::ExampleFolder example_folder(const Examples& examples);

/// Returns the files of the repertoire: those of the examples, their SMPL model, their ratings and
/// their scales, which determine every clip made from the examples.
std::vector<std::filesystem::path> repertoire_files(const Manifest& manifest);

/// Returns the names of the examples, without reading a motion. Throws Error.
std::vector<std::string> example_names(const Manifest& manifest);

/// Returns the names under which answers may refer to the examples, without reading a motion.
/// Throws Error.
std::vector<RatedExample> rated_examples(const Manifest& manifest);

/// Returns the names of all motion files in the examples' folder without their endings, sorted:
/// those that `include` matches and those that are motions by their ending. Throws Error.
std::vector<std::string> stems_in_folder(const Examples& examples);

/// Whether a file of the examples' folder may contain several motions, of which a take chooses one.
/// Throws Error.
bool may_hold_takes(const Examples& examples);

/// Returns the companion files to which a motion file may refer: all files in its folder with the
/// extension of its format's companion files (.asf for .amc), in upper or lower case; of BIDS
/// motion also the channels, and of a frame of OpenPose the other frames of its recording.
std::vector<std::filesystem::path> motion_parts(const std::filesystem::path& file);

/// Returns the answers in the file that the manifest's ratings name. Throws Error.
Answers given_answers(const Manifest& manifest);

/// Returns the contents of that file as they are kept with a study: without the columns that may
/// identify participants, which affect no answer (identifying_columns.h). Throws Error.
std::string kept_ratings(const Manifest& manifest);

}  // namespace mien::pipeline
