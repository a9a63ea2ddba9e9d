#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// Path of the manifest as it was run, stored with the copies of the inputs: with the changes by
/// the command line, and referring to the copies. It reproduces the study.
inline constexpr char as_run_path[] = "inputs/as-run.yaml";

/// A file that describes a study, and its copy in the study's folder.
struct InputCopy {
  std::filesystem::path source;
  std::string path;  ///< "inputs/answers.csv"
};

/// Returns the copies to make: the manifest first, then scales, recipes, ratings, the texts and
/// scales of the questionnaire, the texts of the matching experiment, sounds, and sets, without
/// duplicates.
/// Files in the manifest's folder keep their relative paths, so that the copied manifest finds
/// them.
std::vector<InputCopy> input_copies(const Manifest& manifest);

/// Returns the contents of a copy: those of the file, except that ratings are without the columns
/// that may identify participants (kept_ratings). Throws Error.
std::string contents_of_copy(const Manifest& manifest, const InputCopy& copy);

/// Writes the copies and `as_run_path` into the study's folder. `as_read` are the hashes of the
/// inputs when the study was planned; throws Error if one has changed since.
void put_inputs(const Manifest& manifest, const std::map<std::string, Hash>& as_read, Store& store);

/// Returns the names of the inputs that are not copied (motions, SMPL models and characters), by
/// their absolute paths: the names of the file's folder and of the file, "captures/walk.bvh".
/// Folders with the same name are numbered: "captures (2)/walk.bvh". Where the folder is on the
/// machine is not part of it.
std::map<std::filesystem::path, std::string> names_of_uncopied_inputs(const Manifest& manifest);

/// Returns the hashes of all input files of the study: of the contents that are copied, and of the
/// files that are not. Keys are the paths of the copies and, for
/// files that are not copied, their names (names_of_uncopied_inputs).
std::map<std::string, Hash> hashes_of_inputs(const Manifest& manifest);

}  // namespace mien::pipeline
