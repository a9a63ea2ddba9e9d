#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/places.h"
#include "pipeline/commands/line/command.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/look/look_options.h"
#include "pipeline/manifest/output.h"
#include "pipeline/production/film/film.h"
#include "scenes/stage/layout.h"

namespace mien::pipeline {

/// An output as the options of a command say it, and where they say it ("size", "crop", …).
struct OutputReading {
  Output output;
  Places places;
};

/// The options of `output:` in a manifest that concern the picture, as options of a command: named,
/// described and limited as the manifest's schema does it.
class OutputFlags {
 public:
  /// --size, --scale, …, which must not outlive this.
  std::vector<CommandOption> options();

  /// Throws Faults for what the schema does not allow.
  OutputReading read() const;

 private:
  CommandOption option_of(const std::string& key);

  std::map<std::string, std::string> given_;  ///< key → YAML text
  std::map<std::string, bool> is_array_;
};

/// What the command line of `mien render` says.
struct RenderOptions {
  std::vector<std::string> files;
  std::string take;  ///< of files with several; empty: their first
  std::string out;
  OutputFlags output;
  LookOptions look;
  std::string layout = "superimposed";
  std::string background = "shown";
  std::string dots;
  std::optional<std::string> still;  ///< seconds, or "middle"
  std::uint64_t seed = 0;
  int jobs = 0;
  bool repeat = false;
};

/// What is made of it, and how.
struct RenderPlan {
  std::filesystem::path out;  ///< its ending says what
  Look look;
  FilmSettings settings;
};

/// Throws Faults and Error for what the file, the look and the output do not allow each other, by
/// the rules of a manifest.
RenderPlan plan_of(const RenderOptions& options);

/// Whether one picture is made, not a film of many.
bool is_still(const RenderOptions& options, const RenderPlan& plan);

scenes::Layout layout_of(const RenderOptions& options);

/// Whether a file is a picture, not a video.
bool is_picture(const std::filesystem::path& out);

/// ".mp4, .lossless.mp4, …"
std::string video_endings();

}  // namespace mien::pipeline
