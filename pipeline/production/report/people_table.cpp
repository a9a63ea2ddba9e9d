#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "motion/biomechanics/people_contact.h"
#include "motion/math/geometry.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/tables.h"
#include "scenes/cameras/camera_rig.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

namespace {

/// A person of a film.
struct ShownPerson {
  const Stimulus& stimulus;
  std::size_t number;
  motion::Vec3 begins;  ///< as the front camera sees it: to the right, up, towards it
  double turn_degrees;
  std::string nearest;  ///< name of the person whose hand comes nearest
  std::optional<motion::NearestHands> hands;

  const Person& person() const { return stimulus.people[number]; }
  Look look() const { return look_of_person(stimulus, person()); }
  std::string colour() const {
    return person().colour.empty() ? std::string(scenes::person_colour(number)) : person().colour;
  }
  std::string swapped() const {
    for (const auto& [name, from] : stimulus.swap)
      if (name == person().name) return from;
    return "";
  }
};

/// Numbers of a table, without the last bits.
double in_tenths_of_millimetres(double metres) { return std::round(1e4 * metres) / 1e4; }

constexpr auto people_columns = table_of<ShownPerson>(
    "metrics/people.csv", "person of a stimulus with several people",
    {{"stimulus", "", "id of the stimulus", [](auto& r) { return r.stimulus.id; }},
     {"person", "", "name of the person", [](auto& r) { return r.person().name; }},
     {"motion", "", "id of the person's motion, as in other tables and names of files",
      [](auto& r) { return r.person().motion.id; }},
     {"swapped_from", "",
      "stimulus or person whose motion it is, as `swap` names it; empty for the person's own",
      [](auto& r) { return r.swapped(); }},
     {"colour", "", "colour of the figure", [](auto& r) { return r.colour(); }},
     {"figure", "", "figure type", [](auto& r) { return scenes::kind_of(r.look().figure).name; }},
     {"figure_options", "", "figure options that differ from the defaults, as JSON",
      [](auto& r) { return figure_options(r.look()); }},
     {"start_s", "s", "time of the film at which the motion begins",
      [](auto& r) { return r.person().start; }},
     {"x_m", "m", "position of the pelvis when the film begins: to the right of the stage's middle",
      [](auto& r) { return in_tenths_of_millimetres(r.begins.x()); }},
     {"z_m", "m", "the same towards the front camera",
      [](auto& r) { return in_tenths_of_millimetres(r.begins.z()); }},
     {"turn_deg", "°",
      "direction in which the person goes or faces, to the left of one that faces the front camera",
      [](auto& r) { return std::round(10.0 * r.turn_degrees) / 10.0; }},
     {"nearest_hand_of", "", "person whose hand comes nearest to a hand of this one",
      [](auto& r) { return r.nearest; }},
     {"nearest_hand_m", "m", "distance of these hands (wrists or palms) then",
      [](auto& r) { return r.hands ? in_tenths_of_millimetres(r.hands->distance_m) : NAN; }},
     {"nearest_hand_s", "s", "time of the film at which they are nearest",
      [](auto& r) { return r.hands ? r.hands->frame / r.stimulus.output.fps : NAN; }}});

void find_nearest_hand(const std::vector<motion::Clip>& clips, ShownPerson& shown) {
  const motion::Clip& own = clips[shown.number];
  if (!motion::is_body(own.body)) return;
  for (std::size_t other = 0; other < clips.size(); ++other) {
    if (other == shown.number || !motion::is_body(clips[other].body)) continue;
    const motion::NearestHands hands = motion::nearest_hands(own, clips[other]);
    if (shown.hands && shown.hands->distance_m <= hands.distance_m) continue;
    shown.hands = hands;
    shown.nearest = shown.stimulus.people[other].name;
  }
}

std::vector<ShownPerson> shown_people(const Manifest& manifest, Motions& motions) {
  std::vector<ShownPerson> rows;
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.people.empty()) continue;
    const std::vector<motion::Clip> clips = placed_people(stimulus, motions);
    const motion::Quat to_camera = motion::heading(stage_front(stimulus, clips)).conjugate();
    for (std::size_t i = 0; i < clips.size(); ++i) {
      const motion::Vec3 forward = to_camera * scenes::action_of(clips[i]).forward;
      const double turn = std::atan2(forward.x(), forward.z()) / motion::radians_per_degree;
      const motion::Vec3 begins = to_camera * clips[i].poses.front().root_position;
      ShownPerson shown{stimulus, i, begins, turn, "", {}};
      find_nearest_hand(clips, shown);
      rows.push_back(std::move(shown));
    }
  }
  return rows;
}

}  // namespace

const StudyTable people_table = study_table<people_columns, shown_people>;

}  // namespace mien::pipeline
