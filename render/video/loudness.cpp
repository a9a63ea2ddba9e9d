#include "render/video/loudness.h"

#include <algorithm>
#include <memory>

#include <ebur128.h>

#include "render/error.h"

namespace mien::render {

namespace {

struct FreeMeter {
  void operator()(ebur128_state* meter) const { ebur128_destroy(&meter); }
};

void check_meter(int code) {
  if (code != EBUR128_SUCCESS) throw Error("the loudness of a sound could not be measured");
}

}  // namespace

Loudness ebur128_loudness(const Sound& sound) {
  const auto channels = static_cast<unsigned>(sound.channels);
  const std::unique_ptr<ebur128_state, FreeMeter> meter(
      ebur128_init(channels, sound_rate, EBUR128_MODE_I | EBUR128_MODE_TRUE_PEAK));
  if (!meter) throw Error("the loudness of a sound could not be measured");
  // One channel is heard from two loudspeakers, as players play it.
  if (channels == 1) check_meter(ebur128_set_channel(meter.get(), 0, EBUR128_DUAL_MONO));
  check_meter(ebur128_add_frames_float(meter.get(), sound.samples.data(),
                                       static_cast<std::size_t>(sound.frames())));
  Loudness loudness;
  check_meter(ebur128_loudness_global(meter.get(), &loudness.integrated_lufs));
  double peak = 0.0;
  for (unsigned channel = 0; channel < channels; ++channel) {
    double of_channel = 0.0;
    check_meter(ebur128_true_peak(meter.get(), channel, &of_channel));
    peak = std::max(peak, of_channel);
  }
  loudness.true_peak_dbtp = decibels_of(peak);
  return loudness;
}

std::string ebur128_version() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  ebur128_get_version(&major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace mien::render
