#include "motion/formats/fbx/fbx_timing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "motion/error.h"
#include "motion/formats/reading/frame_rate.h"

namespace mien::motion {

namespace {

constexpr double usual_rate = 30.0;

double seconds_of(std::int64_t ticks) {
  return static_cast<double>(ticks) / static_cast<double>(fbx_ticks_per_second);
}

/// "24", "29.97": a number with at most three decimals.
std::string short_number(double number) {
  std::array<char, 64> text{};
  const double shown = std::clamp(number, -1e15, 1e15);
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), shown, std::chars_format::fixed, 3);
  std::string written(text.data(), error == std::errc{} ? end : text.data());
  while (written.ends_with('0')) written.pop_back();
  if (written.ends_with('.')) written.pop_back();
  return written;
}

/// The span of all keys, and the keys of the curve with the most.
struct Keys {
  std::int64_t first = 0;
  std::int64_t last = 0;
  const FbxCurve* longest = nullptr;
};

Keys keys_of(const FbxAnimation& animation) {
  Keys keys;
  for (const FbxTrack& track : animation.tracks) {
    for (const int c : track.curves) {
      if (c < 0) continue;
      const FbxCurve& curve = animation.curves[static_cast<size_t>(c)];
      if (keys.longest == nullptr) {
        keys = {curve.keys.front().time, curve.keys.back().time, &curve};
      }
      keys.first = std::min(keys.first, curve.keys.front().time);
      keys.last = std::max(keys.last, curve.keys.back().time);
      if (curve.keys.size() > keys.longest->keys.size()) keys.longest = &curve;
    }
  }
  return keys;
}

/// Keys per second if the keys are evenly spaced; else 0.
double rate_of_keys(const FbxCurve& curve) {
  constexpr size_t fewest = 8;
  const std::vector<FbxKey>& keys = curve.keys;
  if (keys.size() < fewest) return 0.0;
  const double step =
      seconds_of(keys.back().time - keys.front().time) / static_cast<double>(keys.size() - 1);
  if (!(step > 0.0)) return 0.0;
  for (size_t k = 0; k < keys.size(); ++k) {
    const double expected = step * static_cast<double>(k);
    if (std::abs(seconds_of(keys[k].time - keys.front().time) - expected) > 0.02 * step) return 0.0;
  }
  const double rate = snapped_frame_rate(1.0 / step);
  return rate >= 9.99 && rate <= 1000.0 ? rate : 0.0;
}

double chosen_rate(const FbxScene& scene, const Keys& keys, const ReadOptions& options,
                   std::vector<std::string>& notes) {
  const double stated = scene.settings.frames_per_second;
  const double of_keys = keys.longest == nullptr ? 0.0 : rate_of_keys(*keys.longest);
  if (of_keys > 0.0 && stated > 0.0 && of_keys > 1.001 * stated) {
    notes.push_back("The file states " + short_number(stated) +
                    " frames per second, but there are " + short_number(of_keys) +
                    " keys per second: " + short_number(of_keys) + " frames are used.");
    return of_keys;
  }
  if (stated > 0.0) return stated;
  if (of_keys > 0.0) return of_keys;
  const double given = options.frames_per_second.value_or(usual_rate);
  if (!(given >= 1.0 && given <= 1000.0)) {
    throw Error({scene.document.file}, "the given frame rate is not from 1 to 1000 per second",
                "give the number of frames per second");
  }
  return given;
}

}  // namespace

FbxTiming fbx_timing(const FbxScene& scene, const FbxAnimation& animation,
                     const std::optional<FbxTake>& take, const ReadOptions& options,
                     std::vector<std::string>& notes) {
  const Keys keys = keys_of(animation);
  FbxTiming timing;
  timing.frames_per_second = chosen_rate(scene, keys, options, notes);
  if (take)
    timing.first =
        std::clamp<std::int64_t>(take->start, -(std::int64_t{1} << 60), std::int64_t{1} << 60);
  if (keys.longest == nullptr) return timing;
  std::int64_t first = keys.first;
  std::int64_t last = keys.last;
  if (take && take->stop > take->start) {
    first = std::max(first, take->start);
    last = std::min(last, take->stop);
  }
  if (first > last) return timing;
  const double seconds = seconds_of(last - first);
  if (!(seconds <= 3600.0)) {
    throw Error({scene.document.file}, "the motion is longer than an hour",
                "cut the motion into shorter files");
  }
  timing.first = first;
  timing.frames = static_cast<size_t>(std::lround(seconds * timing.frames_per_second)) + 1;
  const double stated = take ? seconds_of(take->stop) - seconds_of(take->start) : 0.0;
  if (stated > seconds + 1.5 / timing.frames_per_second) {
    notes.push_back("The take lasts " + short_number(stated) + " s, but its keys " +
                    short_number(seconds) + " s; the frames without keys are left out.");
  }
  return timing;
}

std::int64_t time_of_frame(const FbxTiming& timing, std::size_t frame) {
  return timing.first +
         std::llround(static_cast<double>(frame) * static_cast<double>(fbx_ticks_per_second) /
                      timing.frames_per_second);
}

}  // namespace mien::motion
