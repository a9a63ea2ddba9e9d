#include "pipeline/study/questionnaire/experiment/media.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using render::VideoKind;

/// A video format that all current browsers play.
struct WebVideo {
  VideoKind kind;
  const char* type;
};

/// In order of preference, the most widely supported first.
constexpr std::array web_videos = {WebVideo{VideoKind::mp4, "video/mp4"},
                                   WebVideo{VideoKind::webm, "video/webm"},
                                   WebVideo{VideoKind::webm_av1, "video/webm"}};

constexpr char people_type[] = "application/octet-stream";

/// In the output folder of a study.
constexpr char turned_folder[] = ".mien/turned";

std::optional<WebVideo> web_video_of(const Output& output) {
  for (const WebVideo& video : web_videos)
    if (std::ranges::find(output.video, video.kind) != output.video.end()) return video;
  return std::nullopt;
}

std::set<std::string> stimuli_in(const std::vector<SessionPlan>& plans) {
  std::set<std::string> stimuli;
  for (const SessionPlan& plan : plans) {
    for (const Trial& trial : plan.trials) {
      stimuli.insert(trial.stimuli.begin(), trial.stimuli.end());
      for (const std::vector<std::string>& shown : trial.adaptive.by_level)
        stimuli.insert(shown.begin(), shown.end());
      if (!trial.reference.empty()) stimuli.insert(trial.reference);
    }
  }
  return stimuli;
}

/// Of a motion that is turned: people in the figures of the film or, where these cannot be turned,
/// the motion file.
MediaFile motion_of(const Stimulus& stimulus, const fs::path& folder, const std::string& token,
                    TurnedMotions& turned) {
  const std::size_t frames = static_cast<std::size_t>(
      parse_film_record(read_file(folder / film_record_path(stimulus.id))).film_frames);
  const double seconds = static_cast<double>(frames) / stimulus.output.fps;
  if (const std::optional<TurnedMotion> people = turned.of(stimulus, token))
    return {.file = people->file,
            .ending = ".people",
            .type = people_type,
            .seconds = seconds,
            .figures = people->figures};
  return {.file = folder / "clips" / (stimulus.id + ".glb"),
          .ending = ".glb",
          .type = glb_type,
          .seconds = seconds};
}

MediaFile video_of(const Stimulus& stimulus, const fs::path& folder) {
  const WebVideo kind = *web_video_of(stimulus.output);
  const std::string_view name = render::traits_of(kind.kind).name;
  const FilmRecord film = parse_film_record(read_file(folder / film_record_path(stimulus.id)));
  const auto video = std::ranges::find(film.videos, name, &VideoRecord::format);
  if (video == film.videos.end())
    throw Error({folder.string()}, fmt::format("has no {} of {}", name, stimulus.id),
                "make the study again with mien run");
  const std::array<int, 2> size = stimulus.output.shown_size();
  return {.file = folder / video->file,
          .ending = std::string(render::traits_of(kind.kind).ending),
          .type = kind.type,
          .seconds = video->duration_s,
          .width = size[0],
          .height = size[1],
          .has_sound = video->sound.has_value()};
}

}  // namespace

Manifest with_media(Manifest manifest) {
  const Questionnaire& questionnaire = questionnaire_of(manifest);
  const std::vector<std::string> ids = shown_stimuli(manifest);
  const std::set<std::string> shown(ids.begin(), ids.end());
  for (Stimulus& stimulus : manifest.stimuli) {
    if (!shown.contains(stimulus.id)) continue;
    std::vector<std::string>& clips = stimulus.output.clips;
    if (questionnaire.view == ShownAs::turn && stimulus.people.empty() &&
        std::ranges::count(clips, "glb") == 0)
      clips.emplace_back("glb");
    if (questionnaire.view == ShownAs::video && !web_video_of(stimulus.output))
      throw Error(place_of(manifest.places, stimulus.path),
                  fmt::format("{} has no video format that browsers play", stimulus.id),
                  "add mp4 or webm to output: video:");
  }
  return manifest;
}

MediaFiles media_of(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                    const fs::path& folder) {
  const bool is_turned = questionnaire_of(manifest).view == ShownAs::turn;
  TurnedMotions turned(manifest, folder / turned_folder);
  MediaFiles media;
  for (const std::string& id : stimuli_in(plans)) {
    const Stimulus& stimulus = *find_stimulus(manifest, id);
    const std::string token = media_token(manifest, id);
    MediaFile file =
        is_turned ? motion_of(stimulus, folder, token, turned) : video_of(stimulus, folder);
    std::error_code unknown;
    if (!fs::is_regular_file(file.file, unknown))
      throw Error({file.file.string()}, "is not there", "make the study again with mien run");
    file.token = token;
    file.sha256 = sha256_of(read_file(file.file));
    media.emplace(id, std::move(file));
  }
  return media;
}

std::string media_token(const Manifest& manifest, const std::string& stimulus) {
  return "m" + hash_of(fmt::format("{}/media/{}", manifest.seed, stimulus)).substr(0, 14);
}

}  // namespace mien::pipeline
