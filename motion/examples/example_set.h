#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/examples/make_example.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Selection of the motion files of a set of examples.
struct ExampleFolder {
  std::filesystem::path path;
  std::string include = "*";  ///< pattern of file names (matches_glob)
  std::string exclude;        ///< pattern; empty excludes nothing
  std::string take;           ///< name of the motion in files with several; empty: the first
  CycleChoice cycle = CycleChoice::automatic;
  bool shorten_names = true;  ///< name examples by the part of the file name in which they differ
  std::vector<std::pair<std::string, std::string>> names;  ///< file stem → name; takes precedence
  /// File stem → manual keytimes, seconds (make_example.h). Empty: they are detected; otherwise
  /// every file needs the same number.
  std::vector<std::pair<std::string, std::vector<double>>> keytimes;
  /// False: each motion keeps its own body and keytimes.
  bool blendable = true;
};

/// The selected motion files, sorted by name. Throws Error if the folder or files do not exist.
std::vector<std::filesystem::path> example_files(const ExampleFolder& folder);

/// Names of the examples of these files, in their order. Throws Error if a name occurs twice.
std::vector<std::string> example_names(const ExampleFolder& folder);

/// The source of an example.
struct ExampleOrigin {
  std::filesystem::path file;
  double frames_per_second = 0.0;  ///< of the file
  int file_frames = 0;
  FrameRange frames;         ///< range of the file that the example was cut from
  bool is_mirrored = false;  ///< the range is one step; the other step is its mirror image
};

/// A set of examples and its sources.
struct LoadedExamples {
  ExampleSet set;
  std::vector<std::string> file_stems;  ///< aligned with the examples
  std::vector<ExampleOrigin> origins;   ///< aligned with the examples
  std::vector<std::string> warnings;    ///< sentences that name the example
};

/// Reads the files, maps all files of one rig together, cuts and straightens each motion
/// (make_example.h), and, to be blended, puts all on the first one's body (retarget.h). Throws
/// Error naming the file that cannot be used: unreadable, not human, with another number of
/// keytimes than the first, a duplicate name, or manual keytimes for a file that does not exist.
LoadedExamples load_examples(const ExampleFolder& folder);

/// Whether a file name matches a pattern of `*` (any characters), `?` (any one), `[abc]`, `[a-z]`,
/// `[!a]` (one of, one not of) and `{walk,run}` (either; may be nested). Upper and lower case
/// differ.
bool matches_glob(std::string_view pattern, std::string_view name);

/// Short labels for files that belong together: the common prefix and suffix of all stems (names
/// without extension) are removed, in whole parts between "_", "." and spaces.
/// {"dataset-1_walk_sad_001", "dataset-1_walk_proud_001"} gives {"sad", "proud"}. A single stem
/// stays as it is.
std::vector<std::string> labels_from_names(std::span<const std::string> stems);

}  // namespace mien::motion
