#include "motion/gestures/hand_hits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/math/filter.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double longest_turn = 0.25;  // seconds

/// A hand's path relative to the hips, and where its shoulder and the other hand are.
struct HandPath {
  std::vector<Vec3> places;
  std::vector<Vec3> velocities;
  std::vector<Vec3> accelerations;
  std::vector<Vec3> from_shoulder;
  std::vector<Vec3> to_other_hand;
};

HandPath path_of(const Clip& clip, bool left) {
  const BodyJoint hand = left ? LeftWrist : RightWrist;
  HandPath path;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> places = world_positions(clip.body, pose);
    path.places.push_back(places[hand] - pose.root_position);
    path.from_shoulder.push_back(places[hand] - places[left ? LeftShoulder : RightShoulder]);
    path.to_other_hand.push_back(places[mirrored(hand)] - places[hand]);
  }
  const double rate = clip.frames_per_second;
  const SignalEnds ends = clip.loops ? SignalEnds::periodic : SignalEnds::open;
  path.places = low_pass(path.places, std::min(12.5, 0.3 * rate), rate, ends);
  path.velocities = derivative(path.places, rate, ends);
  path.accelerations = derivative(path.velocities, rate, ends);
  return path;
}

double median_length(const std::vector<Vec3>& vectors) {
  std::vector<double> lengths;
  for (const Vec3& vector : vectors) lengths.push_back(vector.norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

bool is_earlier(const HandHit& a, const HandHit& b) { return a.frame < b.frame; }

/// Looks for hits in the path of one hand. Frames of a loop go on at its beginning.
class HitFinder {
 public:
  HitFinder(const Clip& clip, bool left, const HandHitOptions& options)
      : options_(options),
        left_(left),
        loops_(clip.loops),
        count_(clip.frame_count()),
        rate_(clip.frames_per_second),
        path_(path_of(clip, left)),
        least_deceleration_(std::max(options.least_deceleration,
                                     options.least_share * median_length(path_.accelerations))) {}

  std::vector<HandHit> hits() const {
    std::vector<HandHit> found;
    for (int t = loops_ ? 0 : 1; t < (loops_ ? count_ : count_ - 1); ++t) {
      if (!is_fastest(t)) continue;
      const std::optional<HandHit> hit = hit_after(t);
      const auto is_same = [&](const HandHit& other) { return other.frame == hit->frame; };
      if (hit && std::none_of(found.begin(), found.end(), is_same)) {
        found.push_back(*hit);
      }
    }
    std::vector<HandHit> confirmed;
    for (const HandHit& hit : found)
      if (hit.deceleration >= options_.single_deceleration || is_repeated(hit, found))
        confirmed.push_back(hit);
    std::stable_sort(confirmed.begin(), confirmed.end(), is_earlier);
    find_turns(confirmed);
    return confirmed;
  }

 private:
  std::size_t at(int frame) const {
    return static_cast<std::size_t>(((frame % count_) + count_) % count_);
  }
  bool exists(int frame) const { return loops_ || (frame >= 0 && frame < count_); }
  double speed(int frame) const { return path_.velocities[at(frame)].norm(); }

  bool is_fastest(int frame) const {
    return speed(frame) >= options_.least_speed && speed(frame) >= speed(frame - 1) &&
           speed(frame) > speed(frame + 1);
  }

  /// The stop or turn after the moment of the highest speed.
  std::optional<HandHit> hit_after(int fastest) const {
    const Vec3 direction = path_.velocities[at(fastest)].normalized();
    const int longest = static_cast<int>(std::ceil(options_.longest_stop * rate_ + 0.5));
    double deceleration = 0.0;
    for (int t = fastest; t <= fastest + longest && exists(t); ++t) {
      deceleration = std::max(deceleration, -path_.accelerations[at(t)].dot(direction));
      const double along = path_.velocities[at(t)].dot(direction);
      if (along > 0.1 * speed(fastest)) continue;
      // The frame before may be nearer to the turn.
      const double before = path_.velocities[at(t - 1)].dot(direction);
      const int frame = std::abs(before) < std::abs(along) ? t - 1 : t;
      if (deceleration < least_deceleration_ || !meets_something(frame, direction)) break;
      return HandHit{left_, static_cast<int>(at(frame)), speed(fastest), deceleration};
    }
    return std::nullopt;
  }

  bool meets_something(int frame, const Vec3& direction) const {
    const double least = 0.5;  // within 60°
    const Vec3& to_other = path_.to_other_hand[at(frame)];
    return direction.dot(path_.from_shoulder[at(frame)].normalized()) > least ||
           -direction.y() > least ||
           (to_other.norm() < options_.hands_together &&
            direction.dot(to_other.normalized()) > least);
  }

  /// The slowest moment between each hit and the next one.
  void find_turns(std::vector<HandHit>& hits) const {
    const int longest = static_cast<int>(std::lround(longest_turn * rate_));
    for (std::size_t i = 0; i < hits.size(); ++i) {
      HandHit& hit = hits[i];
      HandHit& next = hits[(i + 1) % hits.size()];
      if (next.frame <= hit.frame && !loops_) continue;
      const int gap =
          next.frame > hit.frame ? next.frame - hit.frame : next.frame - hit.frame + count_;
      int turn = 0;
      for (int away = (gap + 3) / 4; away <= gap - gap / 4; ++away) {
        const bool is_slower = turn == 0 || speed(hit.frame + away) < speed(hit.frame + turn);
        if (is_slower) turn = away;
      }
      if (turn == 0 || speed(hit.frame + turn) > 0.5 * hit.speed) continue;
      if (turn <= longest) hit.until_turn = turn;
      if (gap - turn <= longest) next.since_turn = gap - turn;
    }
  }

  bool is_repeated(const HandHit& hit, const std::vector<HandHit>& found) const {
    return std::any_of(found.begin(), found.end(), [&](const HandHit& other) {
      return other.frame != hit.frame &&
             (path_.places[at(other.frame)] - path_.places[at(hit.frame)]).norm() <=
                 options_.repeat_metres;
    });
  }

  const HandHitOptions& options_;
  bool left_;
  bool loops_;
  int count_;
  double rate_;
  HandPath path_;
  double least_deceleration_;
};

}  // namespace

std::vector<HandHit> hand_hits(const Clip& clip, const HandHitOptions& options) {
  if (clip.frame_count() < 3) return {};
  std::vector<HandHit> hits = HitFinder(clip, true, options).hits();
  const std::vector<HandHit> right = HitFinder(clip, false, options).hits();
  hits.insert(hits.end(), right.begin(), right.end());
  std::stable_sort(hits.begin(), hits.end(), is_earlier);
  return hits;
}

}  // namespace mien::motion
