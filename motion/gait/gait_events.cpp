#include "motion/gait/gait_events.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/event_contact.h"
#include "motion/math/filter.h"
#include "motion/math/peaks.h"
#include "motion/math/percentile.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double shortest_seconds = 0.06;
constexpr double exchange_overlap = 0.03;  // seconds in which feet that run may both touch
constexpr double fall_seconds = 0.12;      // before a landing, in which a run is highest
constexpr double least_rise = 0.015;       // metres; people who run rise by several centimetres
constexpr double beside_seconds = 0.4;
constexpr double tellable_seconds = 0.25;  // over which noise hides no fall
constexpr double least_fall = -4.0;        // m/s²

double mean_pelvis_height(const Clip& clip, int first, int last) {
  first = std::max(first, 0);
  last = std::min(last, clip.frame_count() - 1);
  double sum = 0.0;
  for (int t = first; t <= last; ++t) sum += clip.poses[t].root_position.y();
  return sum / (last - first + 1);
}

/// Whether the pelvis falls through a long gap between plants. In one that it does not, a foot
/// slides or is too short on the floor to be seen.
bool falls(const Clip& clip, int first, int last) {
  const double seconds = (last - first + 2) / clip.frames_per_second;
  if (seconds < tellable_seconds) return true;
  const auto height = [&](int frame) {
    return clip.poses[std::clamp(frame, 0, clip.frame_count() - 1)].root_position.y();
  };
  const double bend = height(first - 1) - 2.0 * height((first + last) / 2) + height(last + 1);
  return bend / (0.25 * seconds * seconds) < least_fall;
}

/// The plant that ends latest before `frame`; null when there is none.
const FootPlant* last_before(const std::vector<FootPlant>& plants, int frame) {
  const FootPlant* latest = nullptr;
  for (const FootPlant& plant : plants) {
    if (plant.last < frame && (!latest || plant.last > latest->last)) latest = &plant;
  }
  return latest;
}

bool touches(const std::vector<FootPlant>& plants, int frame) {
  return std::any_of(plants.begin(), plants.end(), [frame](const FootPlant& plant) {
    return plant.first <= frame && frame <= plant.last;
  });
}

constexpr double slowest_travel = 0.2;  // m/s below which the direction is where the pelvis faces
constexpr double confirm_seconds = 0.1;
constexpr double settle_seconds = 0.25;
constexpr double margin_seconds = 0.15;  // from either end of a clip

std::vector<double> along(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                          const std::vector<Vec3>& directions, double rate) {
  std::vector<double> progress;
  for (size_t t = 0; t < from.size(); ++t) progress.push_back((to[t] - from[t]).dot(directions[t]));
  return low_pass(progress, gait_cutoff_hz(rate), rate);
}

/// First or last frames of the stretches in which the foot touches.
std::vector<int> contact_edges(const std::vector<FootPlant>& plants, bool left, bool starts) {
  std::vector<int> edges;
  for (const FootPlant& plant : plants) {
    if (plant.left == left) edges.push_back(starts ? plant.first : plant.last);
  }
  return edges;
}

void add_events(std::vector<GaitEvent>& events, std::vector<double> progress, bool left,
                GaitEvent::Kind kind, const std::vector<FootPlant>& plants, double rate) {
  if (kind == GaitEvent::Kind::toe_off) {
    for (double& value : progress) value = -value;
  }
  const double range = percentile(progress, 95) - percentile(progress, 5);
  const std::vector<int> edges = contact_edges(plants, left, kind == GaitEvent::Kind::heel_strike);
  for (const Peak& peak :
       prominent_peaks(progress, std::max(0.05, 0.3 * range), margin_seconds * rate)) {
    const bool confirmed = std::any_of(edges.begin(), edges.end(), [&](int edge) {
      return std::abs(edge - peak.place) <= confirm_seconds * rate + 0.5;
    });
    events.push_back({kind, left, peak.place, confirmed});
  }
}

/// Where running feet relieve each other almost at once (slow runs hardly fly): the body is then
/// high, whereas in walking it is lowest between two single supports. As flights, which may be
/// empty or, where contacts overlap, end before they begin.
std::vector<Flight> exchanges(const Clip& clip, const std::vector<FootPlant>& plants) {
  const double rate = clip.frames_per_second;
  const auto beside = static_cast<int>(std::lround(beside_seconds * rate));
  const auto falling = static_cast<int>(std::lround(fall_seconds * rate));
  std::vector<Flight> found;
  for (const FootPlant& landing : plants) {
    for (const FootPlant& take_off : plants) {
      if (take_off.left == landing.left || take_off.first >= landing.first) continue;
      if (take_off.last >= landing.last) continue;
      const double gap = (landing.first - take_off.last - 1) / rate;
      if (gap <= -exchange_overlap || gap >= shortest_seconds) continue;
      const double rise = mean_pelvis_height(clip, landing.first - falling, landing.first) -
                          mean_pelvis_height(clip, landing.first - beside, landing.first + beside);
      if (rise > least_rise) {
        found.push_back({take_off.last + 1, landing.first - 1, take_off.left, landing.left});
      }
    }
  }
  return found;
}

/// Moves the toe off before and the heel strike after each flight to where contact ends and begins.
/// A running foot is farthest in front of the pelvis some time before it lands: strikes whose
/// landing is not seen, as at the end of a take, are moved by the same time.
void settle_by_flights(std::vector<GaitEvent>& events, const std::vector<Flight>& flights,
                       double rate) {
  std::vector<double> lags;
  const auto settle = [&](GaitEvent::Kind kind, bool left, double frame) {
    GaitEvent* nearest = nullptr;
    for (GaitEvent& event : events) {
      if (event.kind != kind || event.left != left) continue;
      const double distance = std::abs(event.frame - frame);
      if (distance > settle_seconds * rate) continue;
      if (!nearest || distance < std::abs(nearest->frame - frame)) nearest = &event;
    }
    if (!nearest) return;
    if (kind == GaitEvent::Kind::heel_strike) lags.push_back(frame - nearest->frame);
    nearest->frame = frame;
    nearest->confirmed = true;
  };
  for (const Flight& flight : flights) {
    settle(GaitEvent::Kind::toe_off, flight.takes_off_left, flight.first - 0.5);
    settle(GaitEvent::Kind::heel_strike, flight.lands_left, flight.last + 0.5);
  }
  if (lags.empty()) return;
  const double lag = percentile(lags, 50);
  for (GaitEvent& event : events) {
    if (event.kind == GaitEvent::Kind::heel_strike && !event.confirmed) event.frame += lag;
  }
}

std::vector<GaitEvent> events_of_take(const Clip& clip, const std::vector<FootPlant>& plants) {
  const FootProgress progress = foot_progress(clip);
  const double rate = clip.frames_per_second;
  std::vector<GaitEvent> events;
  add_events(events, progress.left_heel, true, GaitEvent::Kind::heel_strike, plants, rate);
  add_events(events, progress.right_heel, false, GaitEvent::Kind::heel_strike, plants, rate);
  add_events(events, progress.left_toe, true, GaitEvent::Kind::toe_off, plants, rate);
  add_events(events, progress.right_toe, false, GaitEvent::Kind::toe_off, plants, rate);
  settle_by_flights(events, foot_changes(clip, plants), rate);
  std::erase_if(events, [&](const GaitEvent& event) { return event.frame > clip.frame_count(); });
  std::stable_sort(events.begin(), events.end(),
                   [](const GaitEvent& a, const GaitEvent& b) { return a.frame < b.frame; });
  return events;
}

}  // namespace

std::vector<Flight> flights(const Clip& clip, const std::vector<FootPlant>& plants) {
  const double rate = clip.frames_per_second;
  const auto beside = static_cast<int>(std::lround(beside_seconds * rate));
  std::vector<Flight> found;
  for (const FootPlant& landing : plants) {
    const FootPlant* take_off = last_before(plants, landing.first);
    if (!take_off || touches(plants, landing.first - 1)) continue;
    const int first = take_off->last + 1;
    const int last = landing.first - 1;
    const bool is_up = mean_pelvis_height(clip, first, last) >
                       mean_pelvis_height(clip, first - beside, last + beside);
    if ((last - first + 1) / rate < shortest_seconds || !is_up) continue;
    if (!falls(clip, first, last)) continue;
    found.push_back({first, last, take_off->left, landing.left});
  }
  return found;
}

std::vector<Flight> foot_changes(const Clip& clip, const std::vector<FootPlant>& plants) {
  std::vector<Flight> changes = flights(clip, plants);
  const std::vector<Flight> brief = exchanges(clip, plants);
  changes.insert(changes.end(), brief.begin(), brief.end());
  return changes;
}

std::vector<Vec3> walking_directions(const Clip& clip) {
  std::vector<Vec3> pelvis;
  std::vector<Vec3> facing;
  for (const Pose& pose : clip.poses) {
    pelvis.push_back(horizontal(pose.root_position));
    facing.push_back(horizontal(pose.rotations[Pelvis] * Vec3::UnitZ()));
  }
  const double rate = clip.frames_per_second;
  const std::vector<Vec3> velocity = derivative(low_pass(pelvis, 1.0, rate), rate);
  const std::vector<Vec3> attitude = low_pass(facing, 1.0, rate);
  std::vector<Vec3> directions;
  for (size_t t = 0; t < pelvis.size(); ++t) {
    const Vec3& direction = velocity[t].norm() > slowest_travel ? velocity[t] : attitude[t];
    directions.push_back(direction.norm() > 1e-9 ? Vec3(direction.normalized())
                                                 : Vec3(Vec3::UnitZ()));
  }
  return directions;
}

FootProgress foot_progress(const Clip& clip) {
  const std::vector<Vec3> directions = walking_directions(clip);
  std::array<std::vector<Vec3>, body_joint_count> paths;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> positions = world_positions(clip.body, pose);
    for (const BodyJoint joint : {Pelvis, LeftAnkle, RightAnkle, LeftToe, RightToe}) {
      paths[joint].push_back(positions[joint]);
    }
  }
  const double rate = clip.frames_per_second;
  return {along(paths[Pelvis], paths[LeftAnkle], directions, rate),
          along(paths[Pelvis], paths[RightAnkle], directions, rate),
          along(paths[Pelvis], paths[LeftToe], directions, rate),
          along(paths[Pelvis], paths[RightToe], directions, rate)};
}

std::vector<GaitEvent> gait_events(const Clip& clip) {
  ContactOptions options = event_contact();
  if (!clip.loops) return events_of_take(clip, foot_plants(clip, options));
  options.floor_velocity = floor_velocity(clip);
  const Clip laps = repeated(clip, 3);
  const int frames = clip.frame_count();
  std::vector<GaitEvent> events;
  for (GaitEvent event : events_of_take(laps, foot_plants(laps, options))) {
    event.frame -= frames;
    if (event.frame >= 0.0 && event.frame < frames) events.push_back(event);
  }
  return events;
}

}  // namespace mien::motion
