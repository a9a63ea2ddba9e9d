#include "motion/measures/differences/contact_difference.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/contact.h"
#include "motion/measures/distance/paired_motions.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

/// A stand by time, seconds: from its first frame to the one after its last.
struct PlantInterval {
  double begin = 0.0;
  double end = 0.0;
};

/// One motion's feet.
struct Feet {
  const Clip& clip;
  ContactOptions options;

  explicit Feet(const Clip& of) : clip(of) { options.floor_velocity = floor_velocity(of); }

  std::vector<FootPlant> plants(bool left) const {
    std::vector<FootPlant> all = foot_plants(clip, options);
    std::erase_if(all, [left](const FootPlant& plant) { return plant.left != left; });
    return all;
  }
};

PlantInterval plant_interval(const FootPlant& plant, double rate) {
  return {plant.first / rate, (plant.last + 1) / rate};
}

double overlap(const PlantInterval& a, const PlantInterval& b) {
  return std::min(a.end, b.end) - std::max(a.begin, b.begin);
}

/// Index of the stand that overlaps this one longest; −1 none does.
int longest_overlap(const PlantInterval& stand, const std::vector<PlantInterval>& others) {
  int best = -1;
  double longest = 0.0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (overlap(stand, others[i]) <= longest) continue;
    longest = overlap(stand, others[i]);
    best = static_cast<int>(i);
  }
  return best;
}

std::vector<ContactChange> contact_changes(const std::vector<PlantInterval>& before,
                                           const std::vector<PlantInterval>& now) {
  using enum ContactChange::Kind;
  std::vector<ContactChange> changes;
  std::vector<bool> taken(now.size(), false);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const PlantInterval& was = before[i];
    const int there = longest_overlap(was, now);
    if (there < 0 || longest_overlap(now[there], before) != static_cast<int>(i)) {
      changes.push_back({gone, was.begin, was.end, 0.0, 0.0});
      continue;
    }
    taken[there] = true;
    const ContactChange change = {shifted, was.begin, was.end, now[there].begin - was.begin,
                                  now[there].end - was.end};
    if (std::abs(change.begin_shift) > 1e-6 || std::abs(change.end_shift) > 1e-6)
      changes.push_back(change);
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!taken[i]) changes.push_back({appeared, now[i].begin, now[i].end, 0.0, 0.0});
  }
  std::ranges::stable_sort(changes, {}, &ContactChange::begin_seconds);
  return changes;
}

/// Frames of the first motion at which the other does otherwise.
int frames_otherwise(const Feet& before, const Feet& now, bool left) {
  const std::vector<bool> was = foot_contact(before.clip, left, before.options).foot;
  const std::vector<bool> is = foot_contact(now.clip, left, now.options).foot;
  const double frames_per_frame =
      same_rate(before.clip.frames_per_second, now.clip.frames_per_second)
          ? 1.0
          : now.clip.frames_per_second / before.clip.frames_per_second;
  int frames = 0;
  for (std::size_t t = 0; t < was.size(); ++t) {
    const long there = std::lround(static_cast<double>(t) * frames_per_frame);
    if (there < static_cast<long>(is.size()) && was[t] != is[there]) ++frames;
  }
  return frames;
}

/// Both at the first one's frame rate.
void add_slide(FootDifference& foot, const Feet& before, const Feet& now, bool left) {
  const Clip there = resampled(now.clip, before.clip.frames_per_second);
  const std::vector<SolePoints> was = sole_paths(before.clip, left);
  const std::vector<SolePoints> is = sole_paths(there, left);
  const std::vector<bool> stood = foot_contact(before.clip, left, before.options).foot;
  const std::vector<bool> stands = foot_contact(there, left, now.options).foot;
  Vec3 begun = Vec3::Zero();
  bool standing = false;
  for (std::size_t t = 0; t < std::min(was.size(), is.size()); ++t) {
    const Vec3 apart = is[t].ball - was[t].ball;
    if (!standing) begun = apart;
    standing = stood[t] && stands[t];
    const double slid = standing ? horizontal(apart - begun).norm() : 0.0;
    if (slid <= foot.slide_m) continue;
    foot.slide_m = slid;
    foot.slide_seconds = static_cast<double>(t) / before.clip.frames_per_second;
  }
}

FootDifference foot_difference(const Feet& before, const Feet& now, bool left) {
  const std::vector<FootPlant> was = before.plants(left);
  const double rate = before.clip.frames_per_second;
  std::vector<PlantInterval> plants_before, plants_now;
  for (const FootPlant& plant : was) plants_before.push_back(plant_interval(plant, rate));
  for (const FootPlant& plant : now.plants(left))
    plants_now.push_back(plant_interval(plant, now.clip.frames_per_second));
  FootDifference foot;
  foot.frames = frames_otherwise(before, now, left);
  foot.changes = contact_changes(plants_before, plants_now);
  add_slide(foot, before, now, left);
  return foot;
}

}  // namespace

std::array<FootDifference, 2> contact_differences(const Clip& before, const Clip& now) {
  if (before.frame_count() < 3 || now.frame_count() < 3) return {};
  const Feet was(before);
  const Feet is(now);
  return {foot_difference(was, is, true), foot_difference(was, is, false)};
}

}  // namespace mien::motion
