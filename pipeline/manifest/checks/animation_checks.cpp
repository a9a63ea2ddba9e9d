#include "pipeline/manifest/checks/animation_checks.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/people.h"

namespace mien::pipeline {

namespace {

using motion::BodyEnd;

bool is_hand(const std::optional<BodyEnd>& part) {
  return part == BodyEnd::left_hand || part == BodyEnd::right_hand;
}

class AnimationChecker : public FaultList {
 public:
  using FaultList::FaultList;

  void check(const Stimulus& stimulus) {
    for (const ModificationStep& step : stimulus.modify) {
      const bool is_last = &step == &stimulus.modify.back();
      for (const char* list : {"freeze", "drives", "keys", "constraints", "ends"}) {
        if (is_last || !was_given(member_path(step.path, list))) continue;
        const bool is_ends = std::string_view(list) == "ends";
        add(member_path(step.path, list),
            is_ends ? "later steps would change the ends"
                    : "later steps would change what they place",
            is_ends ? "move it to the last step" : "move them to the last step");
      }
      for (std::size_t i = 0; i < step.keys.size(); ++i)
        check_key(step.keys, i, element_path(member_path(step.path, "keys"), i));
      for (std::size_t i = 0; i < step.constraints.size(); ++i)
        check_constraint(step.constraints[i],
                         element_path(member_path(step.path, "constraints"), i));
    }
  }

 private:
  void check_key(const std::vector<motion::AnimatorKey>& keys, std::size_t index,
                 const std::string& path) {
    const motion::AnimatorKey& key = keys[index];
    const auto is_placed = [](const auto& place) { return place.has_value(); };
    if (std::ranges::none_of(key.places, is_placed) && !key.look_at)
      add(path, "places nothing", "add a part of the body, such as right-hand: [-0.3, 1.4, 0.4]");
    if (key.look_at && key.frame == motion::PlaceFrame::motion)
      add(member_path(path, "look_at"), "there is no such place without the key",
          "use relative: body or room");
    for (std::size_t i = 0; i < index; ++i) {
      if (!(keys[i].at == key.at)) continue;
      for (const auto& [word, end] : body_end_words) {
        const auto at = static_cast<std::size_t>(end);
        if (keys[i].places[at] && key.places[at])
          add(member_path(path, word), "another key places it at the same moment",
              "omit one of them");
      }
      if (keys[i].look_at && key.look_at)
        add(member_path(path, "look_at"), "another key directs it at the same moment",
            "omit one of them");
    }
  }

  void check_constraint(const motion::MotionConstraint& one, const std::string& path) {
    const int conditions = (one.stays ? 1 : 0) + (one.place ? 1 : 0) +
                           (one.follows.empty() ? 0 : 1) + (one.has_region() ? 1 : 0) +
                           (one.distance_to ? 1 : 0) + (one.angle ? 1 : 0) + (one.look_at ? 1 : 0);
    if (conditions != 1) {
      add(path, conditions == 0 ? "has no condition" : "has several conditions",
          "give one of stays, place, follows, within, distance_to, angle and look_at");
      return;
    }
    check_part(one, path);
    check_limits(one, path);
    if (one.from && one.to && one.from->is_frame == one.to->is_frame &&
        one.to->value < one.from->value)
      add(member_path(path, "to"), "is before from", "give from before to");
    check_region(one, path);
  }

  void check_part(const motion::MotionConstraint& one, const std::string& path) {
    if (one.angle) {
      if (one.part) add(member_path(path, "part"), "the angle names its joints", "omit it");
      return;
    }
    if (one.look_at) {
      if (one.part && one.part != BodyEnd::head)
        add(member_path(path, "part"), "only the head looks at a place", "omit it");
      return;
    }
    if (!one.part && was_given(member_path(path, "part"))) return;
    if (!one.part)
      return add(path, "does not say for which part of the body it is",
                 "add part:, such as part: right-hand");
    if (one.distance_to) {
      if (one.part == one.distance_to)
        add(member_path(path, "distance_to"), "is the part itself", "name another part");
      else if (!is_hand(one.part) && !is_hand(one.distance_to))
        add(member_path(path, "part"), "neither of the two parts is a hand, which could move",
            "name a hand");
      return;
    }
    if (one.part == BodyEnd::head && one.stays != motion::Stays::orientation)
      add(member_path(path, "part"), "the head cannot be moved by itself",
          "use look_at, or stays: orientation");
    if (one.part == BodyEnd::pelvis && one.stays == motion::Stays::orientation)
      add(member_path(path, "stays"), "the pelvis cannot be turned by itself",
          "use stays: position");
  }

  void check_limits(const motion::MotionConstraint& one, const std::string& path) {
    const bool has_range = one.distance_to || one.angle;
    if (has_range && !one.at_least && !one.at_most)
      add(path, "has no limits", "add at_least or at_most");
    for (const char* key : {"at_least", "at_most"}) {
      if (!has_range && was_given(member_path(path, key)))
        add(member_path(path, key), "only distances and angles have limits", "omit it");
    }
    if (one.at_least && one.at_most && *one.at_least > *one.at_most)
      add(member_path(path, "at_least"), "is more than at_most", "exchange them");
    if (one.distance_to && one.at_most && *one.at_most <= 0.0)
      add(member_path(path, "at_most"), "is no distance", "give metres above 0");
  }

  void check_region(const motion::MotionConstraint& one, const std::string& path) {
    const char* axes[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < one.within.size(); ++axis) {
      const motion::RegionLimits& limits = one.within[axis];
      if (limits && (*limits)[0] > (*limits)[1])
        add(member_path(path, std::string("within.") + axes[axis]),
            "the least is more than the most", "exchange them");
    }
  }
};

}  // namespace

std::vector<Fault> check_animation(const Manifest& manifest) {
  AnimationChecker checker(manifest.places);
  for (const Stimulus* stimulus : motion_sources(manifest)) {
    if (!stimulus->foil) checker.check(*stimulus);
  }
  return checker.take();
}

}  // namespace mien::pipeline
