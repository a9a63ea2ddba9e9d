#include "pipeline/production/film/film_recorder.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "render/error.h"

namespace mien::pipeline {

FilmRecorder::FilmRecorder(const FilmSettings& settings, int film_frames,
                           std::optional<FilmSound> sound)
    : settings_(settings),
      sound_(std::move(sound)),
      presenter_(settings.output, film_frames, settings.eyes, sound_ ? sound_->held_frames : 0),
      sketch_(settings.output.shown_size()[0], settings.output.shown_size()[1], row_step()) {}

int FilmRecorder::row_step() const {
  int least = std::numeric_limits<int>::max();
  for (const render::VideoKind kind : settings_.output.video)
    least = std::min(least, render::checked_row_step(format_of(kind)));
  return settings_.output.video.empty() ? 1 : least;
}

render::VideoFormat FilmRecorder::format_of(render::VideoKind kind) const {
  const Output& output = settings_.output;
  const auto [width, height] = output.shown_size();
  return {.width = width,
          .height = height,
          .rate = render::frame_rate(output.fps),
          .kind = kind,
          .effort = output.quality == Quality::draft ? render::VideoEffort::fast
                                                     : render::VideoEffort::thorough,
          .loops = settings_.loops};
}

void FilmRecorder::open(const std::filesystem::path& file, render::VideoKind kind) {
  files_.emplace(kind, file);
}

// When a first frame is there: while it is encoded, others are drawn.
void FilmRecorder::begin_files() {
  for (const auto& [kind, file] : files_)
    writers_.emplace(kind,
                     render::VideoWriter(file, format_of(kind), sound_ ? &sound_->sound : nullptr));
  files_.clear();
}

void FilmRecorder::take(const render::Image8& picture) {
  const Stopwatch::Running encoding(settings_.drawing);
  begin_files();
  presenter_.take(picture, [&](const render::Image8& shown) {
    sketch_.add(shown);
    for (auto& [kind, writer] : writers_) writer.write(shown);
  });
}

void FilmRecorder::close() {
  const Stopwatch::Running encoding(settings_.drawing);
  if (static_cast<int>(sketch_.frames.size()) != presenter_.frames().all()) {
    throw render::Error("a video was closed before its film was over");
  }
  for (auto& [kind, writer] : writers_) {
    writer.finish();
    receipts_[kind] = writer.receipt();
  }
  writers_.clear();
}

const render::VideoCheck& FilmRecorder::check(const std::filesystem::path& file,
                                              render::VideoKind kind) {
  const render::VideoReceipt& receipt = receipts_.at(kind);
  if (sound_)
    sound_checks_[kind] = render::check_sound(file, kind, sound_->sound, receipt.sound.value());
  return checks_[kind] =
             render::check_video(file, format_of(kind), sketch_, &receipt, settings_.threads);
}

Hash FilmRecorder::frames_hash() const {
  std::string hashes;
  for (const std::uint64_t hash : sketch_.hashes) hashes += fmt::format("{:016x}", hash);
  return hash_of(hashes);
}

std::optional<render::SoundCheck> FilmRecorder::sound_check(render::VideoKind kind) const {
  const auto found = sound_checks_.find(kind);
  return found == sound_checks_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace mien::pipeline
