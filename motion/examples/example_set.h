#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "motion/examples/make_example.h"
#include "motion/fitting/fit_quality.h"
#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Selection of the motion files of a set of examples.
struct ExampleFolder {
  std::filesystem::path path;
  std::string include = "*";  ///< pattern of file names to include (motion/text/glob.h)
  std::string exclude;        ///< pattern of file names to exclude; empty: none
  ReadOptions how;            ///< which motions of the files; takes apply to formats that have some
  CycleChoice cycle = CycleChoice::automatic;
  bool shorten_names = true;  ///< name examples by the part of the file name in which they differ
  std::vector<std::pair<std::string, std::string>> names;  ///< file stem → name; takes precedence
  /// File stem → manual keytimes, seconds (make_example.h). If empty, keytimes are detected;
  /// otherwise every file must have some and, if the set is blendable, the same number.
  std::vector<std::pair<std::string, std::vector<double>>> keytimes;
  /// False: each motion keeps its own body and keytimes.
  bool blendable = true;
};

/// The selected motion files, sorted by name. Throws Error if the folder cannot be read or contains
/// no such files.
std::vector<std::filesystem::path> example_files(const ExampleFolder& folder);

/// Names of the examples of the selected files, in the order of `example_files`. Throws Error if a
/// name occurs twice.
std::vector<std::string> example_names(const ExampleFolder& folder);

/// The source of an example.
struct ExampleOrigin {
  std::filesystem::path file;
  double frames_per_second = 0.0;  ///< frame rate of the take in the file
  int file_frames = 0;             ///< number of frames of the take
  FrameRange frames;               ///< frames of the take from which the example was cut
  bool is_mirrored = false;        ///< the range is one step; the other step is its mirror image
  std::optional<FitQuality> fit = {};  ///< of a file of points
  bool is_cycle = false;               ///< the example is a gait cycle
};

/// A set of examples and their sources.
struct LoadedExamples {
  ExampleSet set;
  std::vector<std::string> file_stems;  ///< aligned with the examples
  std::vector<ExampleOrigin> origins;   ///< aligned with the examples
  std::vector<std::string> warnings;    ///< sentences that name the example
};

/// Loads a set of examples: reads the files, maps all files of one rig together, and cuts and
/// straightens each motion (make_example.h). If the set is blendable, all motions are retargeted to
/// the body of the first one (retarget.h). If, in addition, no example loops, detected keytimes are
/// reduced to the same number (`even_keytimes`); if all examples run, detected keytimes are those
/// of running (`use_flight_keytimes`). Throws Error naming all files that are unreadable or poses,
/// or one that is not human; in a blendable set, if numbers of keytimes differ, with the number and
/// the reason for each example; if a name occurs twice; and if manual keytimes are missing for a
/// file or refer to one that does not exist.
LoadedExamples load_examples(const ExampleFolder& folder);

/// Short labels for a group of files: the prefix and suffix common to all stems (file names without
/// extension) are removed, in whole parts separated by "_", "." or spaces.
/// {"dataset-1_walk_sad_001", "dataset-1_walk_proud_001"} becomes {"sad", "proud"}. A single stem
/// is returned unchanged, and so are all stems if nothing would remain of one.
std::vector<std::string> labels_from_names(std::span<const std::string> stems);

}  // namespace mien::motion
