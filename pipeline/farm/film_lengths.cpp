#include "pipeline/farm/film_lengths.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/synthesis/motion_record.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

// Beyond so many motion files, the others are taken to last as long as these do on average.
constexpr int most_files_read = 200;

/// What film tasks' costs assume too: cycles of 1.1 s.
int assumed_frames(const Output& output) {
  return std::max(1, static_cast<int>(std::lround(1.1 * output.cycles * output.fps)));
}

std::optional<int> recorded_frames(const std::string& stimulus, const fs::path& folder) {
  const fs::path file = folder / ".mien" / "motions" / (stimulus + ".json");
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  try {
    return parse_motion_record(read_file(file)).shown_frames;
  } catch (const std::runtime_error&) {
    return std::nullopt;  // damaged, and so made again
  }
}

/// Frame counts of stimuli, cached.
class Lengths {
 public:
  Lengths(const Production& production, const fs::path& folder, Motions* motions)
      : manifest_(production.manifest()), folder_(folder), motions_(motions) {}

  int of(const Stimulus& stimulus) {
    const auto known = known_.find(stimulus.id);
    if (known != known_.end()) return known->second;
    const int frames = found(stimulus);
    known_.emplace(stimulus.id, frames);
    return frames;
  }

  /// The longest of those that are shown together.
  int of(const Overlay& overlay) {
    int longest = 1;
    for (const auto& [role, name] : motions_on(overlay)) {
      const Stimulus* stimulus = find_stimulus(manifest_, name);
      longest = std::max(longest,
                         stimulus != nullptr ? of(*stimulus) : assumed_frames(overlay.film.output));
    }
    return longest;
  }

 private:
  int found(const Stimulus& stimulus) {
    if (const auto frames = recorded_frames(stimulus.id, folder_)) return std::max(1, *frames);
    const auto is_blended = [](const auto& person) { return is_blend(person.motion); };
    if (motions_ == nullptr || is_blend(stimulus) ||
        std::ranges::any_of(stimulus.people, is_blended))
      return assumed_frames(stimulus.output);
    if (read_ == most_files_read) return static_cast<int>(frames_read_ / read_);
    const int frames = motions_->shown_frames(stimulus);
    ++read_;
    frames_read_ += frames;
    return frames;
  }

  const Manifest& manifest_;
  const fs::path& folder_;
  Motions* motions_;
  std::map<std::string, int> known_;
  int read_ = 0;
  long long frames_read_ = 0;
};

std::map<std::string, int> lengths(const Production& production, const fs::path& folder,
                                   Motions* motions) {
  std::map<std::string, int> frames;
  Lengths of(production, folder, motions);
  for (const Stimulus& stimulus : production.manifest().stimuli) {
    frames.emplace("film:" + stimulus.id, of.of(stimulus));
  }
  for (const Overlay& overlay : production.manifest().overlays) {
    frames.emplace("film:" + overlay.film.id, of.of(overlay));
  }
  return frames;
}

}  // namespace

std::map<std::string, int> film_lengths(const Production& production, const fs::path& folder) {
  return lengths(production, folder, nullptr);
}

std::map<std::string, int> measured_film_lengths(Production& production, const fs::path& folder) {
  return lengths(production, folder, &production.motions());
}

}  // namespace mien::pipeline
