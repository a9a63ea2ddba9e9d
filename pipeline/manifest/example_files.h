#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/examples/example_set.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/impressions.h"

namespace mien::pipeline {

/// The manifest's folder of examples in the words of the motion core.
motion::ExampleFolder example_folder(const Examples& examples);

/// Files that the repertoire is made of: they determine every clip that is made from it.
std::vector<std::filesystem::path> repertoire_files(const Manifest& manifest);

/// Names of the examples, found without reading a motion. Throws Error.
std::vector<std::string> example_names(const Manifest& manifest);

/// The examples as answers may name them, found without reading a motion. Throws Error.
std::vector<RatedExample> rated_examples(const Manifest& manifest);

/// Stems of all motion files of the examples' folder, chosen or not. Throws Error.
std::vector<std::string> stems_in_folder(const Examples& examples);

/// Files that a motion file of its format may refer to: all beside it with the ending of its parts,
/// in upper or lower case.
std::vector<std::filesystem::path> motion_parts(const std::filesystem::path& file);

/// The answers of the file that the manifest's ratings name. Throws Error.
Answers given_answers(const Manifest& manifest);

}  // namespace mien::pipeline
