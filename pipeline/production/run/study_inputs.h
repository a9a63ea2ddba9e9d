#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// Beside the copies: the manifest as it was run, that is with what the command line changed, and
/// with the copies in the place of the files. It makes the study again.
inline constexpr char as_run_path[] = "inputs/as-run.yaml";

/// A file that describes a study, and its copy in the study's folder.
struct InputCopy {
  std::filesystem::path source;
  std::string path;  ///< "inputs/answers.csv"
};

/// The manifest first; then scales, recipes, ratings and sets, each once. What lies in the
/// manifest's folder keeps its place, so that the copied manifest finds it.
std::vector<InputCopy> input_copies(const Manifest& manifest);

/// Writes the copies and `as_run_path` into the study's folder. `as_read` are the hashes of inputs
/// when the study was planned; throws Error when one has changed since.
void put_inputs(const Manifest& manifest, const std::map<std::string, Hash>& as_read, Store& store);

/// Hashes of all files that the study rests on: copies by their paths, motions and characters by
/// their names and those of their folders, numbered where these are the same. Where these lie is
/// the machine's affair.
std::map<std::string, Hash> hashes_of_inputs(const Manifest& manifest);

}  // namespace mien::pipeline
