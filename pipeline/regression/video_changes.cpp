#include <algorithm>

#include <fmt/format.h>

#include "pipeline/regression/comparer.h"
#include "pipeline/regression/comparison/distinct_numbers.h"

namespace mien::pipeline {

namespace {

/// Adds how the sound has changed. What is heard is compared before encoding, by its hash; bytes
/// that the encoder makes otherwise are no other sound.
void add_sound_change(const std::optional<VideoSoundRecord>& before,
                      const std::optional<VideoSoundRecord>& now, VideoChange& change) {
  const auto seconds = [](const VideoSoundRecord& sound) {
    return static_cast<double>(sound.frames) / sound.rate;
  };
  if (before.has_value() != now.has_value()) {
    change.what.emplace_back(now ? "has a sound now" : "no longer has a sound");
  } else if (!before || before->hash == now->hash) {
    return;
  } else if (before->frames != now->frames) {
    const auto [was, is] = distinct_numbers(seconds(*before), seconds(*now));
    change.what.push_back(fmt::format("sound of {} s → {} s", was, is));
  } else if (before->channels != now->channels) {
    change.what.push_back(
        fmt::format("sound of {} channels → {}", before->channels, now->channels));
  } else {
    change.what.emplace_back("another sound");
  }
  change.same_frames = false;
}

VideoChange video_change(const VideoRecord& before, const VideoRecord& now) {
  VideoChange change{.format = before.format, .what = {}};
  change.same_frames = before.frames == now.frames && before.fps == now.fps;
  if (before.frames != now.frames)
    change.what.push_back(fmt::format("{} frames → {}", before.frames, now.frames));
  if (before.fps != now.fps) {
    const auto [was, is] = distinct_numbers(before.fps, now.fps);
    change.what.push_back(fmt::format("{} frames/s → {}", was, is));
  }
  if (!before.frames_hash.empty() && !now.frames_hash.empty())
    change.same_pictures = before.frames_hash == now.frames_hash;
  if (change.same_frames && !change.same_pictures.value_or(true))
    change.what.emplace_back("shows other frames");
  add_sound_change(before.sound, now.sound, change);
  if (before.identical != now.identical)
    change.what.emplace_back(now.identical ? "now shows its frames exactly"
                                           : "no longer shows its frames exactly");
  if (!now.identical) {
    constexpr double best_psnr_db = 100.0;
    const double was = before.identical ? best_psnr_db : before.worst_psnr_db;
    change.psnr_lost_db = was - now.worst_psnr_db;
  }
  if (!before.identical && !now.identical && before.worst_psnr_db != now.worst_psnr_db) {
    const auto [was, is] = distinct_numbers(before.worst_psnr_db, now.worst_psnr_db, 4);
    change.what.push_back(fmt::format("worst PSNR {} dB → {} dB", was, is));
  }
  if (change.what.empty()) change.what.emplace_back("different content");
  return change;
}

}  // namespace

std::vector<VideoChange> video_changes(const std::vector<VideoFacts>& before,
                                       const std::vector<VideoFacts>& now) {
  std::vector<VideoChange> changes;
  for (const VideoFacts& old : before) {
    const auto same = std::ranges::find_if(
        now, [&](const VideoFacts& video) { return video.record.format == old.record.format; });
    if (same == now.end()) {
      changes.push_back({old.record.format, {"is no longer made"}, false, 0.0, {}, false});
    } else if (same->hash != old.hash) {
      changes.push_back(video_change(old.record, same->record));
    }
  }
  for (const VideoFacts& video : now) {
    const bool is_new = std::ranges::none_of(
        before, [&](const VideoFacts& old) { return old.record.format == video.record.format; });
    if (is_new && !before.empty())
      changes.push_back({video.record.format, {"is new"}, true, 0.0, true});
  }
  return changes;
}

}  // namespace mien::pipeline
