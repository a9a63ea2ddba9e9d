#include <algorithm>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "render/video/sound_file.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

/// 600 s of two channels of 32 bits at 192 kHz, with room for what else a file holds.
constexpr std::uintmax_t most_sound_bytes = 1'000'000'000;

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return text;
}

void check_sound_file(const Stimulus& stimulus, FaultList& list) {
  const std::filesystem::path& file = stimulus.audio->file;
  if (file.empty()) return;
  const std::string audio = member_path(stimulus.path, "audio");
  const std::string own = member_path(audio, "file");
  const std::string at = list.was_given(own) ? own : audio;
  list.check_file(at, file, "a sound file: WAV, FLAC, Opus, Ogg Vorbis or MP3", most_sound_bytes);
  const std::vector<std::string> endings = render::sound_endings();
  if (std::ranges::find(endings, lower_case(file.extension().string())) != endings.end()) return;
  list.add(at, motion::in_quotes(file.extension().string()) + " is not a sound file format",
           "use " + fmt::format("{}", fmt::join(endings, ", ")));
}

void check_videos(const Stimulus& stimulus, FaultList& list) {
  const std::string own = member_path(stimulus.path, "output.video");
  const std::string at = list.was_given(own)              ? own
                         : list.was_given("output.video") ? "output.video"
                                                          : member_path(stimulus.path, "audio");
  const std::string id = motion::in_quotes(stimulus.id);
  if (stimulus.output.video.empty()) {
    return list.add(at, id + " has a sound, but no video is written",
                    "write mp4, webm or mkv, or omit audio");
  }
  for (const render::VideoKind kind : stimulus.output.video) {
    if (!render::sound_codec_of(kind).empty()) continue;
    list.add(at,
             fmt::format("{} has a sound, which {} cannot hold", id, render::traits_of(kind).name),
             "write mp4, webm or mkv, or omit audio");
  }
}

}  // namespace

std::vector<Fault> check_sounds(const Manifest& manifest) {
  FaultList list(manifest.places);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (!stimulus.audio) continue;
    check_sound_file(stimulus, list);
    check_videos(stimulus, list);
    const std::string gain = member_path(stimulus.path, "audio.gain");
    if (manifest.equalize.loudness && list.was_given(gain))
      list.add(gain, "the loudness of all sounds is equalized",
               "omit it, or omit equalize: loudness");
  }
  return list.take();
}

}  // namespace mien::pipeline
