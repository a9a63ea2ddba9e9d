#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/production/film/film_sound.h"
#include "pipeline/production/methods/methods_parts.h"
#include "pipeline/production/methods/prose.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

/// More stimuli than these are only counted.
constexpr std::size_t most_named_sounds = 6;

std::string named_or_counted(const Names& ids) {
  return ids.size() <= most_named_sounds ? listed(ids)
                                         : count_of(ids.size(), "stimulus", "stimuli");
}

/// "wave.wav (from 0.5 s, gain −3 dB)"
std::string source_text(const StimulusSound& sound) {
  std::string text = motion::printable(sound.file.filename().string());
  Names how;
  if (sound.offset > 0.0) how.push_back(fmt::format("from {:g} s", sound.offset));
  if (sound.offset < 0.0) how.push_back(fmt::format("after {:g} s of silence", -sound.offset));
  if (sound.gain != 0.0) how.push_back(fmt::format("gain {:g} dB", sound.gain));
  if (!how.empty()) text += fmt::format(" ({})", fmt::join(how, ", "));
  return text;
}

void describe_sources(MethodsText& out, const std::vector<const Stimulus*>& heard) {
  Names sources, foreign;
  for (const Stimulus* stimulus : heard) {
    add_once(sources, source_text(*stimulus->sound));
    if (stimulus->sound->of != stimulus->id) foreign.push_back(stimulus->id);
  }
  out.say(fmt::format("The videos of {} had sound: {}", named_or_counted([&] {
                        Names ids;
                        for (const Stimulus* stimulus : heard) ids.push_back(stimulus->id);
                        return ids;
                      }()),
                      sources.size() <= most_named_sounds
                          ? listed(sources)
                          : count_of(sources.size(), "sound file", "sound files")));
  if (!foreign.empty())
    out.say(fmt::format("The sound of {} was that of another stimulus", named_or_counted(foreign)));
  if (const auto& mismatch = out.manifest.mismatch) {
    const Names& ids = mismatch->stimuli;
    out.say(fmt::format(
        "The sounds of {} were exchanged in random order so that none kept its own (seed {})",
        ids.empty() ? "all of these" : named_or_counted(ids), mismatch->seed));
  }
}

void describe_lengths(MethodsText& out, const std::vector<const Stimulus*>& heard) {
  const auto with = [&](SoundLength length) {
    Names ids;
    for (const Stimulus* stimulus : heard)
      if (stimulus->sound->length == length) ids.push_back(stimulus->id);
    return ids;
  };
  const Names cut = with(SoundLength::cut);
  const Names held = with(SoundLength::hold);
  if (const Names same = with(SoundLength::error); !same.empty())
    out.say(fmt::format("Sound and film of {} had the same length, to half a frame",
                        named_or_counted(same)));
  if (!cut.empty())
    out.say(fmt::format("The sound of {} was cut where it was longer than the film",
                        named_or_counted(cut)));
  if (!held.empty())
    out.say(fmt::format("The last picture of {} was held where the sound was longer than the film",
                        named_or_counted(held)));
  if (!cut.empty() || !held.empty()) out.say("A shorter sound was followed by silence");
}

void describe_encoding(MethodsText& out, const std::vector<const Stimulus*>& heard) {
  Names codecs;
  for (const Stimulus* stimulus : heard) {
    for (const render::VideoKind kind : stimulus->output.video)
      add_once(codecs, render::sound_codec_of(kind) == "aac" ? "AAC (128 kbit/s per channel)"
                                                             : "Opus (96 kbit/s per channel)");
  }
  out.say(fmt::format(
      "Sounds had a sample rate of 48 kHz and were encoded as {}; each was decoded from its video, "
      "compared with the sound before encoding by cross-correlation, and found without a shift of "
      "a "
      "sample frame",
      listed(codecs)));
  if (out.manifest.equalize.loudness) {
    out.say(fmt::format(
        "Their integrated loudness was equalized to {:g} LUFS by gain{}, with true peaks below "
        "{:g} dBTP; gains and measured values are in metrics/stimuli.csv",
        *out.manifest.equalize.loudness, out.cite({"ebur128"}), most_true_peak_dbtp));
  } else {
    out.say(fmt::format(
        "Their integrated loudness and true peaks were measured{} and are in metrics/stimuli.csv",
        out.cite({"ebur128"})));
  }
}

}  // namespace

void describe_sounds(MethodsText& out) {
  std::vector<const Stimulus*> heard;
  for (const Stimulus& stimulus : out.manifest.stimuli)
    if (stimulus.sound && !stimulus.output.video.empty()) heard.push_back(&stimulus);
  if (heard.empty()) return;
  describe_sources(out, heard);
  describe_lengths(out, heard);
  describe_encoding(out, heard);
}

}  // namespace mien::pipeline
