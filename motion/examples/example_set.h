#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "motion/examples/make_example.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// Motion files that make a set of examples.
struct ExampleFolder {
  std::filesystem::path path;
  std::string include = "*";  ///< pattern of file names (file_labels.h)
  std::string exclude;        ///< pattern; empty leaves nothing out
  std::string take;           ///< of files that may hold several motions; empty: their first
  CycleChoice cycle = CycleChoice::automatic;
  bool shorten_names = true;  ///< name examples by the part of the file name in which they differ
  std::vector<std::pair<std::string, std::string>> names;  ///< file stem → name, goes before
  /// File stem → keytimes by hand, seconds (make_example.h). Empty to find them; otherwise every
  /// file has some, all equally many.
  std::vector<std::pair<std::string, std::vector<double>>> keytimes;
  /// Otherwise each motion stays on its own body, with keytimes of its own.
  bool blendable = true;
};

/// The motion files that are chosen, ordered by name. Throws Error: no such folder, no such file.
std::vector<std::filesystem::path> example_files(const ExampleFolder& folder);

/// Names of the examples that these files make, in their order. Throws Error: a name that occurs
/// twice.
std::vector<std::string> example_names(const ExampleFolder& folder);

/// What an example was cut from.
struct ExampleOrigin {
  std::filesystem::path file;
  double frames_per_second = 0.0;  ///< of the file
  int file_frames = 0;
  FrameRange frames;         ///< of the file, that the example is made of
  bool is_mirrored = false;  ///< they are one step; the other is its mirror image
};

/// A set and where it is from.
struct LoadedExamples {
  ExampleSet set;
  std::vector<std::string> file_stems;  ///< aligned with the examples
  std::vector<ExampleOrigin> origins;   ///< likewise
  std::vector<std::string> warnings;    ///< plain sentences that name the example
};

/// Reads the files, maps all files of one rig together, cuts and straightens each motion
/// (make_example.h), and, to be blended, puts all on the first one's body (retarget.h). Throws
/// Error naming the file that cannot be used: unreadable, no human, another number of keytimes than
/// the first, a name that occurs twice, or keytimes by hand for other files than there are.
LoadedExamples load_examples(const ExampleFolder& folder);

}  // namespace mien::motion
