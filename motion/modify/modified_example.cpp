#include "motion/modify/modified_example.h"

#include <algorithm>
#include <utility>

#include "motion/dynamics/retiming.h"
#include "motion/gestures/acting_hand.h"

namespace mien::motion {

ModifiedExample modified_example(const Example& original, const Modification& modification,
                                 std::vector<double> times) {
  ModifiedClip modified = modify(original.clip, modification);
  // First the gesture has its own timing, then the tempo is that of everything.
  const std::vector<double>& moved = modified.report.gesture_frames;
  const double rate = original.clip.frames_per_second;
  const double before = moved.empty() ? original.clip.duration_seconds() : moved.back() / rate;
  const double now = modified.clip.duration_seconds();
  const Retiming& retiming = modified.report.retiming;
  const bool is_even = retiming.is_even || retiming.sources.empty();
  const auto move = [&](double& time) {
    if (!moved.empty()) time = moved_by_gesture(moved, time * rate) / rate;
    time = is_even ? time * (now / before) : now * retimed_share(time / before, retiming);
  };
  std::vector<double> keytimes = original.keytimes;
  std::for_each(keytimes.begin(), keytimes.end(), move);
  std::for_each(times.begin(), times.end(), move);
  return {{original.name, std::move(modified.clip), std::move(keytimes)},
          std::move(times),
          std::move(modified.report)};
}

Modification without_idle_gesture(Modification modification, const Clip& clip) {
  if (!is_identity(modification.gesture) && !acting_hand(clip)) modification.gesture = {};
  return modification;
}

}  // namespace mien::motion
