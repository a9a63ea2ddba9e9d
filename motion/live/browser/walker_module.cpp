// The functions of the steered walker that a page calls in its WebAssembly module. One walker a
// module. Functions that answer 1 have done it; of those that answer 0, walker_told() and
// walker_told_size() give an error in plain words.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/skeleton/body.h"
#include "motion/steered_walk/live_walk.h"

namespace {

using namespace mien::motion;

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

std::string vector_of(const Vec3& v) {
  return "[" + number(v.x()) + "," + number(v.y()) + "," + number(v.z()) + "]";
}

/// "name":[one,one,…]
template <class List, class Write>
std::string listed(const std::string& name, const List& list, Write&& write) {
  std::string text;
  for (const auto& one : list) text += (text.empty() ? "" : ",") + write(one);
  return quoted(name) + ":[" + text + "]";
}

/// Description of a walker for the page, as JSON: {"set", "moods": […], "body":
/// {"names", "parents", "offsets", "tips"}}, metres; the body as LiveInfo of pages has it.
std::string walker_info(const LiveWalk& walk, const std::string& set) {
  const std::vector<Joint>& joints = walk.gaits.body.joints;
  const std::string body =
      listed("names", joints, [](const Joint& joint) { return quoted(joint.name); }) + "," +
      listed("parents", joints, [](const Joint& joint) { return std::to_string(joint.parent); }) +
      "," + listed("offsets", joints, [](const Joint& joint) { return vector_of(joint.offset); }) +
      "," + listed("tips", joints, [](const Joint& joint) {
        return joint.tip ? vector_of(*joint.tip) : std::string("null");
      });
  return "{\"set\":" + quoted(set) + "," + listed("moods", walk.moods, quoted) + ",\"body\":{" +
         body + "}}";
}

/// A pose as pages show it: of each joint its place (x, y, z) in the world, metres, then of each
/// its rotation (x, y, z, w), joint frame → world, then whether the left and the right foot are
/// planted (1 or 0), then speed (m/s) and heading (°).
void write_frame(const LiveWalk& walk, const Pose& pose, std::vector<double>& frame) {
  frame.clear();
  const JointTransforms joints = world_transforms(walk.gaits.body, pose);
  for (const Vec3& place : joints.positions)
    frame.insert(frame.end(), {place.x(), place.y(), place.z()});
  for (const Quat& turn : joints.rotations)
    frame.insert(frame.end(), {turn.x(), turn.y(), turn.z(), turn.w()});
  for (const SteppingLeg& leg : walk.walker.legs) frame.push_back(leg.swinging ? 0.0 : 1.0);
  frame.push_back(walk.walker.root.speed.value);
  frame.push_back(walk.walker.root.heading / radians_per_degree);
}

LiveWalk walker;
WalkRequest request;
std::vector<double> frame;
std::string told;

template <class Do>
int done(Do act) {
  try {
    act();
    return 1;
  } catch (const std::exception& error) {
    told = error.what();
  } catch (...) {
    told = "the walker failed";
  }
  return 0;
}

/// Names between commas.
bool is_among(std::string_view name, std::string_view names) {
  while (!names.empty()) {
    const std::string_view one = names.substr(0, names.find(','));
    if (one == name) return true;
    names.remove_prefix(std::min(one.size() + 1, names.size()));
  }
  return false;
}

}  // namespace

extern "C" {

/// A walker that stands; moods are those walks of the built-in set that `moods` names (between
/// commas), or all when it is empty. walker_told() is then what walker_info says.
int walker_open(const char* set, std::size_t set_size, const char* moods, std::size_t moods_size) {
  return done([&] {
    const std::string name(set, set_size);
    const std::string_view wanted(moods, moods_size);
    std::vector<NamedStyle> styles = builtin_styles(name);
    if (!wanted.empty())
      std::erase_if(styles, [&](const NamedStyle& one) { return !is_among(one.name, wanted); });
    walker = make_live_walk(styles, standard_body());
    request = {};
    request.moods.assign(walker.moods.size(), 0.0);
    request.moods.front() = 1.0;
    told = walker_info(walker, name);
    write_frame(walker, pose_of(walker.gaits, walker.walker), frame);
  });
}

/// Sets the user's input. A heading that is NaN is not requested; degrees.
void walker_mood(std::size_t mood, double share) {
  if (mood < request.moods.size()) request.moods[mood] = share;
}
void walker_steer(double pace, double heading_deg, double turn_deg_s) {
  request.pace = pace;
  request.heading_deg = std::isnan(heading_deg) ? std::nullopt : std::optional<double>(heading_deg);
  request.turn_deg_s = turn_deg_s;
}

/// Advances the walker by `seconds`; walker_frame() is then its pose (write_frame).
int walker_advance(double seconds) {
  return done([&] { write_frame(walker, advance(walker, seconds, request), frame); });
}
const double* walker_frame() { return frame.data(); }
std::size_t walker_frame_size() { return frame.size(); }

const char* walker_told() { return told.data(); }
std::size_t walker_told_size() { return told.size(); }
}
