#include "motion/modify/modification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "motion/biomechanics/soft_limits.h"
#include "motion/dynamics/tempo_forces.h"
#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/gait_plants.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/feet_apart.h"
#include "motion/modify/foot_repair.h"
#include "motion/modify/held_hands.h"
#include "motion/modify/limb_timing.h"
#include "motion/modify/nine_grid.h"
#include "motion/modify/value_range.h"
#include "motion/modify/variation.h"
#include "motion/skeleton/recorded_hands.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

constexpr double walking_floor = 0.05;  // m/s; a floor that moves faster under a loop is walked on
constexpr double tempo_tolerance = 5e-4;
constexpr double slowest_walk = 0.15;  // m/s
constexpr double heaviest = 3.0;       // weight

bool is_unit(const PathGains& gains) {
  return gains.low == 1.0 && gains.middle == 1.0 && gains.high == 1.0 &&
         std::all_of(gains.bands.begin(), gains.bands.end(), [](double g) { return g == 1.0; });
}

bool turns_nothing(const PoseDifference& difference) {
  return std::all_of(difference.turns.begin(), difference.turns.end(),
                     [](const Quat& turn) { return log(turn).norm() == 0.0; });
}

double towards_one(double value, double strength) { return 1.0 + strength * (value - 1.0); }

/// The loop on its way when its feet walk in place; any other clip as it is.
Clip made_travelling(const Clip& clip) {
  const Vec3 floor = floor_velocity(clip);
  if (floor.norm() < walking_floor) return clip;
  return travelling(clip, -floor * clip.duration_seconds());
}

/// Horizontal way of the whole clip, metres: of a loop its displacement; of another the length of
/// its path without sway, for it may come back to where it began.
double way(const Clip& clip) {
  if (clip.loops) return horizontal(clip.cycle_displacement).norm();
  std::vector<Vec3> path;
  for (const Pose& pose : clip.poses) path.push_back(horizontal(pose.root_position));
  path = low_pass(path, 1.0, clip.frames_per_second);
  double length = 0.0;
  for (size_t t = 1; t < path.size(); ++t) length += (path[t] - path[t - 1]).norm();
  return length;
}

/// Whether the clip gets anywhere, rather than swaying.
bool travels(const Clip& clip) {
  return way(clip) > std::max(0.2, slowest_walk * clip.duration_seconds());
}

Clip with_root_of(Clip clip, const Clip& other) {
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    clip.poses[f].root_position = other.poses[f].root_position;
  }
  clip.cycle_displacement = other.cycle_displacement;
  return clip;
}

/// What foot_plants did not find.
std::string unplanted_feet() {
  const ContactOptions options;
  char text[160];
  std::snprintf(text, sizeof text,
                "none stays within %g cm of its lowest height and slower than %g m/s for %g s, as "
                "when feet slide or walk on a treadmill",
                100.0 * options.height_metres, options.on_speed, options.shortest_plant);
  return text;
}

/// The modification with what its relative changes ask of the posture, in degrees.
Modification in_degrees(Modification m, const Clip& clip, const std::vector<FootPlant>& contacts) {
  const std::vector<PostureChange> posture = posture_of(m.relative, clip, contacts);
  m.posture.insert(m.posture.end(), posture.begin(), posture.end());
  return m;
}

/// The hits that keep their places: those of hands whose timing changes at hits at most. With other
/// changes of timing, a hand would be at the place of a hit a second time.
std::vector<HandHit> held_hits(std::vector<HandHit> hits, const Modification& m) {
  const bool retimes = m.variation > 0.0 || m.acceleration < 0.0 ||
                       (m.acceleration > 0.0 && m.acceleration_place == AccelerationPlace::pauses);
  std::erase_if(hits, [&](const HandHit& hit) {
    return retimes && (hit.left ? m.limbs.left_hand : m.limbs.right_hand);
  });
  return hits;
}

/// The foot plants that a modification needs. Feet of runs are only taken for planted where the
/// height of the body or the swing of the legs depends on it: `by_gait`.
std::vector<FootPlant> contacts_of(const Clip& original, const Modification& m, bool needed,
                                   bool by_gait) {
  if (m.repair == FootRepair::none && !needed && !may_bring_feet_together(m)) return {};
  return by_gait ? gait_plants(original) : foot_plants(original);
}

/// Retiming by one factor is as even as playing a film at another speed.
Retiming timing(const Clip& original, const Tempo& tempo, bool in_gravity,
                const Carriage& carriage) {
  const int count = original.frame_count();
  if (!in_gravity) return retiming(count, original.loops, tempo);
  return retiming(
      count, original.loops, tempo,
      stretched_contacts(count, original.frames_per_second, original.loops, tempo, carriage));
}

void write_remarks(ModificationReport& report, const Modification& asked, bool stays) {
  char text[160];
  const double asked_tempo = report.retiming.factor;
  if (std::abs(report.tempo / asked_tempo - 1.0) > tempo_tolerance) {
    std::snprintf(
        text, sizeof text,
        "tempo %.3f instead of the requested %.3f, because a motion lasts a whole number of frames",
        report.tempo, asked_tempo);
    report.remarks.emplace_back(text);
  }
  if (asked.repair != FootRepair::none && report.plants == 0) {
    report.remarks.push_back("no foot is planted, so feet were not locked: " + unplanted_feet());
  }
  if (report.plants > 0) {
    const bool is_less = report.drift_after_repair <= report.drift_before_repair;
    std::snprintf(text, sizeof text,
                  is_less ? "foot sliding of up to %.1f mm in %d contacts was reduced to %.1f mm"
                          : "foot sliding of up to %.1f mm in %d contacts became up to %.1f mm",
                  1000.0 * report.drift_before_repair, report.plants,
                  1000.0 * report.drift_after_repair);
    report.remarks.emplace_back(text);
  }
  if (report.hand_correction > 0.001) {
    std::snprintf(text, sizeof text,
                  "hands hit where they did before: %d hits were moved back by up to %.0f mm",
                  report.hits, 1000.0 * report.hand_correction);
    report.remarks.emplace_back(text);
  }
  if (std::abs(report.travel_ratio - 1.0) > 0.01) {
    const char* change = report.travel_ratio < 1.0 ? "distance travelled fell to %.0f %%"
                                                   : "distance travelled rose to %.0f %%";
    std::snprintf(text, sizeof text,
                  stays ? "step length changed to %.0f %%; the loop stays in place" : change,
                  100.0 * report.travel_ratio);
    report.remarks.emplace_back(text);
  }
  if (report.largest_limit_excess > radians_per_degree) {
    std::snprintf(text, sizeof text, "joint limits reduced rotations by up to %.0f°",
                  report.largest_limit_excess / radians_per_degree);
    report.remarks.emplace_back(text);
  }
}

/// A motion after its timing: in its posture, within its joints' limits, its feet repaired.
struct Finished {
  Clip posed;
  Clip repaired;
  double largest_limit_excess = 0.0;
};

Finished finished(const Clip& timed, const Clip& reference, const std::vector<FootPlant>& stands,
                  const Modification& m) {
  Finished result{timed, {}, 0.0};
  if (!m.posture.empty() || m.pose_difference) {
    result.posed = with_posture(timed, m.posture, m.pose_difference);
  }
  if (!is_unit(m.stiffness) || m.weight != 1.0)
    result.posed = with_limb_dynamics(result.posed, m.stiffness, m.weight);
  if (m.soft_joint_limits) {
    SoftLimits limited = with_soft_limits(result.posed, reference);
    result.posed = std::move(limited.clip);
    result.largest_limit_excess = limited.largest_excess;
  }
  result.repaired = with_repaired_feet(result.posed, reference, stands, m.repair);
  return result;
}

/// As `finished`, with as much of the thighs' turn inwards as leaves the feet a foot's width apart
/// where they are put down, or as near as they come without it.
Finished finished_with_feet_apart(const Clip& timed, const Clip& reference,
                                  const std::vector<FootPlant>& stands, const Modification& m,
                                  const std::vector<FootPlant>& contacts,
                                  ModificationReport& report) {
  constexpr int halvings = 5;
  Finished whole = finished(timed, reference, stands, m);
  if (!may_bring_feet_together(m)) return whole;
  const auto width = [&](const Clip& clip) { return least_step_width(clip, contacts); };
  const std::optional<double> closest = width(whole.repaired);
  const double foot = foot_width(timed.body);
  if (!closest || *closest >= foot) return whole;
  Finished best = finished(timed, reference, stands, with_feet_together(m, 0.0));
  const double least =
      std::min({foot, width(best.repaired).value_or(foot), width(reference).value_or(foot)});
  if (*closest >= least) return whole;
  double clean = 0.0, crossing = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double share = 0.5 * (clean + crossing);
    Finished tried = finished(timed, reference, stands, with_feet_together(m, share));
    if (width(tried.repaired).value_or(foot) < least) {
      crossing = share;
    } else {
      clean = share;
      best = std::move(tried);
    }
  }
  char text[160];
  std::snprintf(text, sizeof text,
                "the thighs were rotated inwards by %.0f %% of the requested angle: at the full "
                "angle, steps would be %.1f cm wide",
                100.0 * clean, 100.0 * *closest);
  report.remarks.emplace_back(text);
  return best;
}

}  // namespace

bool is_identity(const Modification& m) {
  const bool paths_stay = m.gains ? is_unit(*m.gains) : m.paths == 1.0;
  const bool posture_stays =
      std::all_of(m.posture.begin(), m.posture.end(),
                  [](const PostureChange& change) { return change.degrees == 0.0; }) &&
      (!m.pose_difference || turns_nothing(*m.pose_difference));
  return paths_stay && posture_stays && is_identity(m.gesture) && is_identity(m.relative) &&
         m.acceleration == 0.0 && is_unit(m.tempo) && is_unit(m.stiffness) && m.weight == 1.0 &&
         m.variation == 0.0;
}

Modification scaled(const Modification& modification, double strength) {
  if (strength == 1.0) return modification;
  Modification m = modification;
  m.paths = std::clamp(towards_one(m.paths, strength), 0.0, 2.0);
  if (m.gains) {
    for (double* gain : {&m.gains->low, &m.gains->middle, &m.gains->high}) {
      *gain = std::max(0.0, towards_one(*gain, strength));
    }
    for (double& gain : m.gains->bands) gain = std::max(0.0, towards_one(gain, strength));
  }
  m.acceleration = std::clamp(strength * m.acceleration, -1.0, 1.0);
  for (PostureChange& change : m.posture) change.degrees *= strength;
  if (m.pose_difference) {
    for (Quat& turn : m.pose_difference->turns) turn = exp(strength * log(turn));
  }
  m.gesture = scaled(m.gesture, strength);
  m.relative = scaled(m.relative, strength);
  m.tempo = scaled(m.tempo, strength);
  m.stiffness = scaled(m.stiffness, strength);
  m.weight = std::clamp(towards_one(m.weight, strength), 0.0, heaviest);
  m.variation = std::clamp(strength * m.variation, 0.0, 1.0);
  return m;
}

void check(const Modification& m) {
  check_range("paths", m.paths, 0.0, 2.0);
  check_range("acceleration", m.acceleration, -1.0, 1.0);
  if (const TempoFault fault = fault_of(m.tempo); !fault.wrong.empty())
    throw Error(fault.wrong, fault.remedy);
  for (const auto& [name, value, most] :
       {std::tuple("stiffness of the head", m.stiffness.head, 2.0),
        std::tuple("stiffness of the trunk", m.stiffness.trunk, 2.0),
        std::tuple("stiffness of the left arm", m.stiffness.left_arm, 2.0),
        std::tuple("stiffness of the right arm", m.stiffness.right_arm, 2.0),
        std::tuple("stiffness of the legs", m.stiffness.legs, 1.0)})
    check_range(name, value, 0.0, most);
  check_range("weight", m.weight, 0.0, heaviest);
  check_range("variation", m.variation, 0.0, 1.0);
  for (const PostureChange& change : m.posture) {
    check_range(std::string(name_of(change.unit)), change.degrees, -180.0, 180.0);
  }
  check(m.gesture);
  check(m.relative);
  if (!m.gains) return;
  check_range("gains.low", m.gains->low, 0.0, 100.0);
  check_range("gains.middle", m.gains->middle, 0.0, 100.0);
  check_range("gains.high", m.gains->high, 0.0, 100.0);
  for (const double gain : m.gains->bands) check_range("gains.bands", gain, 0.0, 100.0);
}

namespace {

/// The gesture first, then everything else.
ModifiedClip modify_with_gesture(const Clip& clip, Modification asked) {
  ChangedGesture made = with_gesture(clip, asked.gesture);
  asked.gesture = {};
  ModifiedClip result = modify(made.clip, asked);
  result.report.gesture_frames = std::move(made.frames);
  result.report.remarks.insert(result.report.remarks.begin(), made.remarks.begin(),
                               made.remarks.end());
  return result;
}

}  // namespace

ModifiedClip modify(const Clip& clip, const Modification& asked) {
  check(asked);
  if (!is_body(clip.body)) {
    throw Error("\"" + clip.name + "\" does not move the canonical body",
                "map its recording to the canonical body first");
  }
  ModifiedClip result{clip, {}};
  if (is_identity(asked) || clip.frame_count() < 2) return result;
  if (!is_identity(asked.gesture)) return modify_with_gesture(clip, asked);
  ModificationReport& report = result.report;

  const Clip original = made_travelling(clip);
  const bool at_contacts =
      asked.acceleration > 0.0 && asked.acceleration_place == AccelerationPlace::contacts;
  const bool at_hits =
      asked.acceleration > 0.0 && asked.acceleration_place != AccelerationPlace::pauses;
  const bool in_gravity = asked.gravity == TempoGravity::kept && !is_unit(asked.tempo);
  const bool on_slack_legs = asked.stiffness.legs < 1.0 || asked.weight != 1.0;
  const bool needed =
      at_contacts || in_gravity || on_slack_legs || asked.relative.step_width != 1.0;
  const std::vector<FootPlant> contacts = contacts_of(
      original, asked, needed, in_gravity || on_slack_legs || changes_swing(asked.relative));
  const Modification m = in_degrees(asked, original, contacts);
  const std::vector<FootPlant> plants =
      m.repair == FootRepair::none ? std::vector<FootPlant>{} : contacts;
  const std::vector<HandHit> hits =
      m.repair == FootRepair::plants || at_hits ? hand_hits(original) : std::vector<HandHit>{};
  const Clip moved =
      with_variation(grid_motion(with_swing(original, m.relative), contacts, m, hits), m.variation,
                     m.limbs, m.seed);

  const Carriage carriage =
      in_gravity || on_slack_legs
          ? carriage_of(original, contacts, travels(original) ? way(original) : 0.0)
          : Carriage{};
  report.retiming = timing(original, m.tempo, in_gravity, carriage);
  const Clip reference = retimed(original, report.retiming);
  const auto in_time = [&](const auto& stretches) { return retimed(stretches, report.retiming); };
  const std::vector<FootPlant> stands = in_time(plants);
  if (at_contacts && hits.empty() && contact_frames(contacts, original.frame_count()).empty()) {
    report.remarks.emplace_back(
        "there are no hits of hands and no foot contacts, so acceleration at contacts had no "
        "effect: " +
        (contacts.empty() ? unplanted_feet() : "feet stand throughout"));
  }
  const Clip timed = retimed(moved, report.retiming);
  Finished done = finished_with_feet_apart(
      in_gravity ? with_steps_at_tempo(timed, m.tempo, report.retiming, carriage) : timed,
      reference, stands, m, in_time(contacts), report);
  if (in_gravity) {
    const std::vector<double> played = body_heights(finished(timed, reference, stands, m).repaired);
    done.repaired = with_gravity_kept(done.repaired, played, m.tempo, report.retiming, carriage);
  }
  if (on_slack_legs) {
    done.repaired = with_slack_legs(done.repaired, m.stiffness.legs, m.weight, in_time(contacts),
                                    in_time(carriage.flights));
  }
  report.largest_limit_excess = done.largest_limit_excess;
  report.hits = static_cast<int>(hits.size());
  if (m.repair == FootRepair::plants && !hits.empty()) {
    HeldHands held =
        with_held_hands(done.repaired, reference, in_time(held_hits(hits, m)), travels(original));
    done.repaired = std::move(held.clip);
    report.hand_correction = held.largest_correction;
  }
  Clip& repaired = done.repaired;

  if (reference.frame_count() > 1)
    report.tempo = original.duration_seconds() / reference.duration_seconds();
  report.plants = static_cast<int>(plants.size());
  // Feet that are not repaired slide, too.
  const std::vector<FootPlant> stood =
      in_time(m.repair == FootRepair::none && contacts.empty() ? foot_plants(original) : contacts);
  report.drift_before_repair = planted_drift(with_root_of(done.posed, reference), stood);
  report.drift_after_repair = planted_drift(repaired, stood);
  if (travels(original)) report.travel_ratio = way(repaired) / way(original);
  const bool in_its_place = stays_in_place(clip);
  write_remarks(report, m, in_its_place);
  if (m.hands == FingerPaths::scaled && !has_fingers(clip))
    report.remarks.emplace_back("the motion has no fingers, so that they could not be scaled");

  result.clip = in_its_place ? in_place(repaired) : std::move(repaired);
  result.clip.name = clip.name;
  return result;
}

Clip modified(const Clip& clip, const Modification& modification) {
  return modify(clip, modification).clip;
}

}  // namespace mien::motion
