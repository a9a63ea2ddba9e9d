#include "pipeline/regression/report/report_videos.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/regression/approval.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Kinds that browsers play, and what they call them.
constexpr std::pair<std::string_view, std::string_view> shown_kinds[] = {
    {"mp4", "video/mp4"}, {"webm", "video/webm"}, {"webm-av1", "video/webm"}};

const VideoFacts* find_kind(const std::vector<VideoFacts>& videos, std::string_view kind) {
  const auto found = std::ranges::find_if(
      videos, [&](const VideoFacts& video) { return video.record.format == kind; });
  return found == videos.end() ? nullptr : &*found;
}

void refuse_damage(const fs::path& file, const VideoFacts& video) {
  if (hash_of_file(file) == video.hash) return;
  throw Error({file.string()}, "differs from the approved video",
              "restore it from version control (git checkout, git lfs pull), or approve the "
              "stimulus again");
}

nlohmann::ordered_json source_json(const VideoFacts& video, const std::string& source) {
  return {{"src", source},
          {"frames", video.record.frames},
          {"first", video.first_film_frame},
          {"fps", video.record.fps}};
}

/// Puts a video beside the page. Returns the way to it from there.
std::string put_beside(const fs::path& file, const fs::path& report, const std::string& name) {
  make_folder(report / "videos");
  ResultFile video(report / "videos" / name);
  fs::copy_file(file, video.draft(), fs::copy_options::overwrite_existing);
  video.publish();
  return "videos/" + name;
}

}  // namespace

nlohmann::ordered_json ReportVideos::of(const std::string& id, const Baseline& baseline) {
  const StimulusFacts* approved = baseline.find(id);
  if (study_.empty() || approved == nullptr) return nullptr;
  const std::vector<VideoFacts> made = videos_of(id, study_);
  for (const auto& [kind, media_type] : shown_kinds) {
    const VideoFacts* before = find_kind(approved->videos, kind);
    const VideoFacts* now = find_kind(made, kind);
    if (before == nullptr || now == nullptr) continue;
    const fs::path old_file = baseline.video_file(id, *before);
    const fs::path new_file = study_ / now->record.file;
    if (!fs::is_regular_file(old_file)) continue;
    refuse_damage(old_file, *before);
    const std::uintmax_t bytes = fs::file_size(old_file) + fs::file_size(new_file);
    if (bytes <= bytes_left_) {
      bytes_left_ -= bytes;
      return {{"before", source_json(*before, data_uri(media_type, read_file(old_file)))},
              {"now", source_json(*now, data_uri(media_type, read_file(new_file)))}};
    }
    const std::string ending = new_file.extension().string();
    return {
        {"before", source_json(*before, put_beside(old_file, report_, id + "-before" + ending))},
        {"now", source_json(*now, put_beside(new_file, report_, id + "-now" + ending))}};
  }
  return nullptr;
}

}  // namespace mien::pipeline
