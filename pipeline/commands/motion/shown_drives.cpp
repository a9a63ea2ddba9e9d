#include "pipeline/commands/motion/shown_drives.h"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/animate/body_drive.h"
#include "motion/math/geometry.h"
#include "pipeline/manifest/animation.h"

namespace mien::pipeline {

namespace {

bool is_angle(motion::BodyMovement body) {
  return body == motion::BodyMovement::spine_flexion ||
         body == motion::BodyMovement::spine_lateral || body == motion::BodyMovement::spine_turn;
}

/// Metres per metre, or centimetres per degree.
double shown_slope(const motion::FoundDrive& drive) {
  return is_angle(drive.body) ? 100.0 * drive.slope * motion::radians_per_degree : drive.slope;
}

}  // namespace

nlohmann::ordered_json drives_as_json(const motion::Clip& clip) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  for (const motion::FoundDrive& drive : motion::drives_of(clip)) {
    list.push_back({{"limb", word_of(limb_movement_words, drive.limb)},
                    {"body", word_of(body_movement_words, drive.body)},
                    {"correlation", rounded(drive.correlation)},
                    {"slope", rounded(shown_slope(drive))},
                    {"slope_unit", is_angle(drive.body) ? "cm/deg" : "m/m"},
                    {"limb_range_m", rounded(drive.limb_range)}});
  }
  return list;
}

void show_drives(const motion::Clip& clip, const Console& console) {
  const std::vector<motion::FoundDrive> drives = motion::drives_of(clip);
  if (drives.empty()) return;
  console.out << "drives   hands that follow the body\n";
  for (const motion::FoundDrive& drive : drives) {
    console.out << fmt::format("  {:18} {:18} r {:5.2f}  {:6.2f} {}  range {:.2f} m\n",
                               word_of(limb_movement_words, drive.limb),
                               word_of(body_movement_words, drive.body), drive.correlation,
                               shown_slope(drive), is_angle(drive.body) ? "cm/deg" : "m/m   ",
                               drive.limb_range);
  }
}

}  // namespace mien::pipeline
