#include "motion/skeleton/simultaneous_frames.h"

#include <algorithm>
#include <limits>

namespace mien::motion {

bool cut_to_simultaneous_frames(std::span<Clip> clips, std::span<const int> first_frames) {
  int first = 0;
  int end = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < clips.size(); ++i) {
    first = std::max(first, first_frames[i]);
    end = std::min(end, first_frames[i] + clips[i].frame_count());
  }
  if (first >= end) return false;
  for (std::size_t i = 0; i < clips.size(); ++i)
    clips[i] = cut(clips[i], first - first_frames[i], end - 1 - first_frames[i]);
  return true;
}

}  // namespace mien::motion
