#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/places.h"
#include "pipeline/commands/line/command.h"
#include "pipeline/commands/line/recording_options.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/look/look_options.h"
#include "pipeline/manifest/output.h"
#include "pipeline/production/film/film.h"
#include "scenes/stage/layout.h"

namespace mien::pipeline {

/// An output defined by command-line options, with the location of each value ("size", "crop", …)
/// for error messages.
struct OutputReading {
  Output output;
  Places places;
};

/// The options of `output:` in a manifest that affect the picture, as command-line options with
/// names, descriptions and limits from the manifest's schema.
class OutputFlags {
 public:
  /// The options --size, --scale, …, which must not outlive this object.
  std::vector<CommandOption> options();

  /// The output for the given options. Throws Faults if the schema is violated.
  OutputReading read() const;

 private:
  CommandOption option_of(const std::string& key);

  std::map<std::string, std::string> given_;  ///< key → YAML text
  std::map<std::string, bool> is_array_;
};

/// Command-line options of `mien render`.
struct RenderOptions {
  std::vector<std::string> files;
  RecordingArguments recording;  ///< of all files
  std::string out;
  OutputFlags output;
  LookOptions look;
  scenes::Layout layout = scenes::Layout::superimposed;
  std::string background = "shown";
  std::string dots;                  ///< CSV to write the positions of the dots to; empty: none
  std::optional<std::string> still;  ///< time of a single image: seconds, or "middle"
  std::uint64_t seed = 0;
  int jobs = 0;
  bool repeat = false;  ///< animated images loop forever
};

/// The output file, look and settings for rendering.
struct RenderPlan {
  std::filesystem::path out;  ///< its extension selects the format
  Look look;
  FilmSettings settings;
  std::vector<Fault> warnings;  ///< about options with former names
};

/// The plan for these options. Throws Faults or Error if the output file, look and output options
/// are invalid or incompatible, by the rules for manifests and those for stills.
RenderPlan plan_of(const RenderOptions& options);

/// Whether a single image is rendered instead of a film.
bool is_still(const RenderOptions& options, const RenderPlan& plan);

/// Whether a file name has the extension of an image, .png or .exr.
bool is_picture(const std::filesystem::path& out);

/// The supported extensions of videos: ".mp4, .lossless.mp4, …"
std::string video_endings();

}  // namespace mien::pipeline
