#include "pipeline/production/film/film_sound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/production/film/film_presentation.h"
#include "render/error.h"
#include "render/video/sound_file.h"

namespace mien::pipeline {

namespace {

using render::sound_rate;

std::int64_t sample_frames(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * sound_rate));
}

double rounded_to(double value, double unit) { return std::round(value / unit) * unit; }

/// What cannot be read is the user's file, not a failure of the machine.
render::Sound sound_in(const std::filesystem::path& file) {
  try {
    return render::read_sound(file);
  } catch (const render::Error& error) {
    throw Error(error.what(), "");
  }
}

/// The sound of one stimulus, in its making.
class SoundFitter {
 public:
  SoundFitter(const Stimulus& stimulus, int film_frames)
      : film_(stimulus),
        sound_(*stimulus.sound),
        fps_(stimulus.output.fps),
        film_frames_(film_frames),
        source_(sound_in(sound_.file)),
        offset_(sample_frames(sound_.offset)) {
    if (source_.frames() - offset_ <= 0) {
      throw Error(fmt::format("{} lasts {:.3f} s, and its offset is {:.3f} s", name(),
                              source_.seconds(), sound_.offset),
                  "use a smaller audio.offset");
    }
  }

  FilmSound fit(const std::optional<double>& target_lufs) {
    FilmSound result;
    result.held_frames = held_frames();
    const PresentationFrames frames =
        frames_of(film_.output.presentation, fps_, film_frames_, result.held_frames);
    render::SoundPlacing placing{.offset = offset_,
                                 .begin = sample_frames(frames.before() / fps_),
                                 .length = sample_frames(frames.all() / fps_),
                                 .gain_db = sound_.gain};
    // What follows the film is silent.
    const std::int64_t end =
        sample_frames((frames.before() + film_frames_ + result.held_frames) / fps_);
    const auto place = [&] {
      result.sound = render::placed(source_, placing);
      const auto first_silent = static_cast<std::ptrdiff_t>(end * result.sound.channels);
      std::fill(result.sound.samples.begin() + first_silent, result.sound.samples.end(), 0.0f);
    };
    place();
    render::Loudness loudness = render::loudness_of(result.sound);
    if (target_lufs) {
      placing.gain_db += gain_to(*target_lufs, loudness);
      place();
      loudness = render::loudness_of(result.sound);
    }
    refuse_overload(render::sample_peak(result.sound));
    result.record = record_of(placing, result.held_frames, loudness);
    return result;
  }

 private:
  std::string name() const { return motion::printable(sound_.file.filename().string()); }

  /// How much longer the sound is than the film, seconds.
  double excess() const {
    return static_cast<double>(source_.frames() - offset_) / sound_rate - film_frames_ / fps_;
  }

  int held_frames() const {
    const double more = excess();
    const double half_a_frame = 0.5 / fps_;
    if (sound_.length == SoundLength::error && std::abs(more) > half_a_frame) {
      throw Error(
          fmt::format("{} lasts {:.3f} s from its offset, but the film of {} {:.3f} s", name(),
                      film_frames_ / fps_ + more, motion::in_quotes(film_.id), film_frames_ / fps_),
          "set audio.length to hold or cut, or use another offset");
    }
    if (sound_.length != SoundLength::hold || more <= half_a_frame) return 0;
    return static_cast<int>(std::ceil(more * fps_ - 1e-6));
  }

  double gain_to(double target_lufs, const render::Loudness& loudness) const {
    if (!std::isfinite(loudness.integrated_lufs)) {
      throw Error(fmt::format("the loudness of {} cannot be measured: it is silent, quieter than "
                              "−70 LUFS or shorter than 0.4 s",
                              name()),
                  "use another sound, or omit equalize: loudness");
    }
    const double gain = target_lufs - loudness.integrated_lufs;
    const double peak = loudness.true_peak_dbtp + gain;
    if (peak > most_true_peak_dbtp) {
      const double reachable =
          std::floor(10.0 * (target_lufs - (peak - most_true_peak_dbtp))) / 10.0;
      throw Error(fmt::format("at {:.1f} LUFS, {} has a true peak of {:.1f} dBTP; {:.0f} dBTP may "
                              "not be exceeded",
                              target_lufs, name(), peak, most_true_peak_dbtp),
                  fmt::format("equalize to at most {:.1f} LUFS", reachable));
    }
    return gain;
  }

  void refuse_overload(double peak) const {
    if (peak <= 1.0) return;
    const double excess_db = render::decibels_of(peak);
    throw Error(fmt::format("{} exceeds full scale by {:.1f} dB with its gain", name(), excess_db),
                fmt::format("use an audio.gain of at most {:.1f}",
                            std::floor(10.0 * (sound_.gain - excess_db)) / 10.0));
  }

  SoundRecord record_of(const render::SoundPlacing& placing, int held,
                        const render::Loudness& loudness) const {
    SoundRecord record;
    record.file = sound_.file.filename().string();
    record.of = sound_.of;
    record.offset_s = sound_.offset;
    record.gain_db = rounded_to(placing.gain_db, 0.001);
    record.length = std::string(name_of(sound_.length));
    record.source_s = rounded_to(source_.seconds(), 1e-6);
    record.channels = source_.channels;
    record.held_frames = held;
    const double more = excess() - held / fps_;
    record.cut_s = rounded_to(std::max(0.0, more), 1e-6);
    record.silence_s = rounded_to(std::max(0.0, -more), 1e-6);
    if (std::isfinite(loudness.integrated_lufs))
      record.loudness_lufs = rounded_to(loudness.integrated_lufs, 0.01);
    if (std::isfinite(loudness.true_peak_dbtp))
      record.true_peak_dbtp = rounded_to(loudness.true_peak_dbtp, 0.01);
    return record;
  }

  const Stimulus& film_;
  const StimulusSound& sound_;
  double fps_;
  int film_frames_;
  render::Sound source_;
  std::int64_t offset_;
};

}  // namespace

std::optional<FilmSound> film_sound(const Stimulus& stimulus,
                                    const std::optional<double>& target_lufs, int film_frames) {
  if (!stimulus.sound) return std::nullopt;
  return SoundFitter(stimulus, film_frames).fit(target_lufs);
}

}  // namespace mien::pipeline
