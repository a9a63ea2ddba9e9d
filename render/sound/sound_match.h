#pragma once

#include <cstdint>
#include <optional>

#include "render/sound/sound.h"

namespace mien::render {

/// How a decoded sound agrees with the one that was encoded.
struct SoundMatch {
  /// By how many sample frames it is heard too late (negative: too early); not set for silence, in
  /// which no shift can be measured.
  std::optional<std::int64_t> offset_frames;
  /// Correlation of the two at that offset, −1 … 1, in the stretch that was compared; 1 for silence
  /// that is decoded as silence (below −60 dBFS), otherwise 0.
  double correlation = 0.0;
};

/// Greatest shift that match_sounds finds, sample frames: 50 ms.
inline constexpr std::int64_t most_sound_shift = 2400;

/// Compares the loudest third of a second (16384 sample frames) of the written sound, channels
/// added, with the decoded sound at shifts up to most_sound_shift, or only up to 100 if the two
/// differ by less than a tenth of their energy without a shift. The offset is the shift with the
/// least squared difference, but 0 if no other is better by a tenth, because periodic sounds are
/// alike at several shifts, or if the two differ by less than 0.04 % of their energy without one,
/// because a codec's phase moves low tones by as much as half a sample frame. Both have the same
/// number of channels.
SoundMatch match_sounds(const Sound& written, const Sound& decoded);

}  // namespace mien::render
