#include "motion/formats/mvnx/mvnx_hands.h"

#include <algorithm>
#include <array>

namespace mien::motion {

namespace {

constexpr std::array<std::string_view, 5> mvn_fingers = {"First", "Second", "Third", "Fourth",
                                                         "Fifth"};
constexpr std::array<std::string_view, 3> thumb_bones = {"MC", "PP", "DP"};
constexpr std::array<std::string_view, 4> finger_bones = {"MC", "PP", "MP", "DP"};

constexpr double nearest_metres = 0.3;  ///< of a carpus to what it is seen from

/// The labels of a hand in MVN's order.
std::vector<std::string> labels_of_hand(const std::string& side) {
  std::vector<std::string> labels = {side + "Carpus"};
  for (const std::string_view finger : mvn_fingers) {
    const auto add = [&](std::string_view bone) {
      labels.push_back(side + std::string(finger) + std::string(bone));
    };
    if (finger == mvn_fingers.front())
      std::ranges::for_each(thumb_bones, add);
    else
      std::ranges::for_each(finger_bones, add);
  }
  return labels;
}

/// The numbers of one hand beside those of the body.
struct TrackedHand {
  const MvnxSubject& subject;
  const MvnxHand& hand;
  std::size_t body_hand;  ///< index of the body's segment
  std::size_t segments;

  Quat body_turn(std::size_t frame) const {
    const double* q = &subject.orientations[4 * (frame * subject.segments.size() + body_hand)];
    return Quat(q[0], q[1], q[2], q[3]).normalized();
  }
  Vec3 body_place(std::size_t frame) const {
    return Vec3(&subject.positions[3 * (frame * subject.segments.size() + body_hand)]);
  }
  Vec3 place(std::size_t frame, std::size_t segment) const {
    return Vec3(&hand.positions[3 * (frame * segments + segment)]);
  }
  Quat turn(std::size_t frame, std::size_t segment) const {
    const double* q = &hand.orientations[4 * (frame * segments + segment)];
    return {q[0], q[1], q[2], q[3]};
  }
};

enum class HandSpace { world, hand, unknown };

HandSpace space_of(const TrackedHand& tracked) {
  const Vec3 carpus = tracked.place(0, 0);
  if ((carpus - tracked.body_place(0)).norm() < nearest_metres) return HandSpace::world;
  return carpus.norm() < nearest_metres ? HandSpace::hand : HandSpace::unknown;
}

void append_hand(const TrackedHand& tracked, HandSpace space, std::size_t frame,
                 std::vector<double>& orientations, std::vector<double>& positions) {
  const bool is_seen_from_hand = space == HandSpace::hand;
  for (std::size_t s = 0; s < tracked.segments; ++s) {
    Quat turn = tracked.turn(frame, s);
    Vec3 place = tracked.place(frame, s);
    if (is_seen_from_hand) {
      turn = tracked.body_turn(frame) * turn;
      place = tracked.body_place(frame) + tracked.body_turn(frame) * place;
    }
    orientations.insert(orientations.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
    positions.insert(positions.end(), {place.x(), place.y(), place.z()});
  }
}

/// The frames with the hand's numbers after those of the body.
void join(const TrackedHand& tracked, HandSpace space, MvnxSubject& joined) {
  const MvnxSubject& before = tracked.subject;
  const auto count = static_cast<std::ptrdiff_t>(before.segments.size());
  std::vector<double> orientations, positions;
  for (std::size_t frame = 0; frame < before.frames.size(); ++frame) {
    const auto at = static_cast<std::ptrdiff_t>(frame) * count;
    orientations.insert(orientations.end(), before.orientations.begin() + 4 * at,
                        before.orientations.begin() + 4 * (at + count));
    positions.insert(positions.end(), before.positions.begin() + 3 * at,
                     before.positions.begin() + 3 * (at + count));
    append_hand(tracked, space, frame, orientations, positions);
  }
  joined.orientations = std::move(orientations);
  joined.positions = std::move(positions);
  joined.segments.insert(joined.segments.end(), tracked.hand.segments.begin(),
                         tracked.hand.segments.end());
}

void name_hand_segments(const std::string& side, std::size_t frames, MvnxHand& hand) {
  const std::vector<std::string> labels = labels_of_hand(side);
  if (!hand.segments.empty() || hand.orientations.size() != 4 * frames * labels.size()) return;
  for (const std::string& label : labels) hand.segments.push_back({label, std::nullopt});
}

/// Why a hand is left out; empty if it is added.
std::string added_hand(const std::string& side, MvnxSubject& subject) {
  MvnxHand& hand = subject.hands[side == "Left" ? 0 : 1];
  const std::size_t frames = subject.frames.size();
  name_hand_segments(side, frames, hand);
  const std::size_t count = hand.segments.size();
  if (count == 0 || hand.orientations.size() != 4 * frames * count ||
      hand.positions.size() != 3 * frames * count)
    return "not every frame has the numbers of all its segments";
  const auto body_hand = std::ranges::find(subject.segments, side + "Hand", &MvnxSegment::label);
  if (body_hand == subject.segments.end() || hand.segments.front().label != side + "Carpus")
    return "its segments are not those of MVN";
  const MvnxSubject before = subject;
  const TrackedHand tracked{before, before.hands[side == "Left" ? 0 : 1],
                            static_cast<std::size_t>(body_hand - subject.segments.begin()), count};
  const HandSpace space = space_of(tracked);
  if (space == HandSpace::unknown) return "it is far from the hand of the body";
  join(tracked, space, subject);
  return "";
}

}  // namespace

std::string parent_in_mvn_hand(std::string_view label) {
  for (const std::string side : {"Left", "Right"}) {
    if (!label.starts_with(side)) continue;
    const std::string_view part = label.substr(side.size());
    if (part == "Carpus") return side + "Hand";
    for (const std::string_view finger : mvn_fingers) {
      if (!part.starts_with(finger)) continue;
      const std::string_view bone = part.substr(finger.size());
      const std::string beginning = side + std::string(finger);
      if (bone == "MC") return side + "Carpus";
      if (bone == "PP") return beginning + "MC";
      if (bone == "MP" && finger != mvn_fingers.front()) return beginning + "PP";
      if (bone == "DP") return beginning + (finger == mvn_fingers.front() ? "PP" : "MP");
    }
  }
  return "";
}

void add_tracked_hands(MvnxSubject& subject, std::vector<std::string>& notes) {
  for (const std::string side : {"Left", "Right"}) {
    const MvnxHand& hand = subject.hands[side == "Left" ? 0 : 1];
    if (hand.orientations.empty() && hand.positions.empty()) continue;
    const std::string why = added_hand(side, subject);
    if (!why.empty())
      notes.push_back("The finger tracking of the " +
                      std::string(side == "Left" ? "left" : "right") + " hand is left out: " + why +
                      ".");
  }
}

}  // namespace mien::motion
