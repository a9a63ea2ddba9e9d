#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "motion/math/geometry.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/hand.h"

namespace mien::test {

using namespace mien::motion;

/// A segment of MVN, the joint at its origin, and how it follows the canonical body: its frame is
/// that of `follows`, and its origin stands at `place` there.
struct MvnSegment {
  const char* name;
  const char* parent;
  const char* joint;
  BodyJoint follows;
  Vec3 place = Vec3::Zero();
};

inline const std::vector<MvnSegment>& mvn_segments() {
  static const std::vector<MvnSegment> segments = {
      {"Pelvis", "", "", Pelvis},
      {"L5", "Pelvis", "jL5S1", Spine},
      {"L3", "L5", "jL4L3", Spine, {0.0, 0.06, 0.0}},
      {"T12", "L3", "jL1T12", Chest},
      {"T8", "T12", "jT9T8", Chest, {0.0, 0.09, 0.01}},
      {"Neck", "T8", "jT1C7", Neck},
      {"Head", "Neck", "jC1Head", Head},
      {"RightShoulder", "T8", "jRightT4Shoulder", RightClavicle},
      {"RightUpperArm", "RightShoulder", "jRightShoulder", RightShoulder},
      {"RightForeArm", "RightUpperArm", "jRightElbow", RightElbow},
      {"RightHand", "RightForeArm", "jRightWrist", RightWrist},
      {"LeftShoulder", "T8", "jLeftT4Shoulder", LeftClavicle},
      {"LeftUpperArm", "LeftShoulder", "jLeftShoulder", LeftShoulder},
      {"LeftForeArm", "LeftUpperArm", "jLeftElbow", LeftElbow},
      {"LeftHand", "LeftForeArm", "jLeftWrist", LeftWrist},
      {"RightUpperLeg", "Pelvis", "jRightHip", RightHip},
      {"RightLowerLeg", "RightUpperLeg", "jRightKnee", RightKnee},
      {"RightFoot", "RightLowerLeg", "jRightAnkle", RightAnkle},
      {"RightToe", "RightFoot", "jRightBallFoot", RightToe},
      {"LeftUpperLeg", "Pelvis", "jLeftHip", LeftHip},
      {"LeftLowerLeg", "LeftUpperLeg", "jLeftKnee", LeftKnee},
      {"LeftFoot", "LeftLowerLeg", "jLeftAnkle", LeftAnkle},
      {"LeftToe", "LeftFoot", "jLeftBallFoot", LeftToe},
  };
  return segments;
}

/// A direction of the canonical body (X left, Y up, Z forward) along MVN's axes (X forward, Y left,
/// Z up).
inline Vec3 along_mvn(const Vec3& v) { return {v.z(), v.x(), v.y()}; }

/// What the numbers of tracked fingers are seen from.
enum class MvnxHands { none, world, hand };

struct MvnxLook {
  MvnxHands hands = MvnxHands::none;
  bool has_segments = true;
  bool has_joints = true;
  bool has_positions = true;
  bool has_calibration = true;
  std::string subject = "Anna";
  std::string rate = "frameRate=\"60\"";
  double milliseconds = 1000.0 / 60.0;  ///< between frames; 0: no times
};

namespace mvnx_parts {

inline std::string numbers(const std::vector<double>& values) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9);
  for (size_t i = 0; i < values.size(); ++i) text << (i == 0 ? "" : " ") << values[i];
  return text.str();
}

/// A segment of MVN's hand and the joint of the handed body that it follows; −1: the wrist.
struct HandSegment {
  std::string name;
  int finger_joint = -1;
};

inline std::vector<HandSegment> hand_segments(bool left) {
  const std::string side = left ? "Left" : "Right";
  std::vector<HandSegment> segments = {{side + "Carpus"}};
  const char* fingers[] = {"First", "Second", "Third", "Fourth", "Fifth"};
  const char* bones[] = {"MC", "PP", "MP", "DP"};
  for (int f = 0; f < fingers_per_hand; ++f) {
    const bool is_thumb = f == 0;
    for (int bone = 0; bone < 4; ++bone) {
      if (is_thumb && bone == 2) continue;
      const int segment = is_thumb ? (bone == 3 ? 2 : bone) : bone - 1;
      const std::string name = side + fingers[f] + bones[bone];
      const int joint = segment < 0 ? -1 : finger_joint(left, Finger(f), segment);
      segments.push_back({name, joint});
    }
  }
  return segments;
}

/// Orientations and positions of the segments of a hand in a frame, as elements of MVNX.
inline std::string hand_frame(const Skeleton& body, const Pose& pose, bool left, MvnxHands from) {
  const JointTransforms world = world_transforms(with_fingers(body), with_fingers(pose));
  const auto wrist = static_cast<size_t>(left ? LeftWrist : RightWrist);
  const Quat back = from == MvnxHands::hand ? world.rotations[wrist].conjugate() : Quat::Identity();
  const Vec3 origin = from == MvnxHands::hand ? world.positions[wrist] : Vec3(Vec3::Zero());
  std::vector<double> orientations, positions;
  for (const HandSegment& segment : hand_segments(left)) {
    const size_t joint = segment.finger_joint < 0
                             ? wrist
                             : static_cast<size_t>(body_joint_count + segment.finger_joint);
    const Quat q = back * world.rotations[joint];
    const Vec3 axis = along_mvn(q.vec());
    orientations.insert(orientations.end(), {q.w(), axis.x(), axis.y(), axis.z()});
    const Vec3 place = along_mvn(back * (world.positions[joint] - origin));
    positions.insert(positions.end(), {place.x(), place.y(), place.z()});
  }
  const std::string side = left ? "Left" : "Right";
  return "<orientationFingers" + side + ">" + numbers(orientations) + "</orientationFingers" +
         side + ">\n<positionFingers" + side + ">" + numbers(positions) + "</positionFingers" +
         side + ">\n";
}

inline std::string hand_segment_list(bool left) {
  const std::string side = left ? "Left" : "Right";
  std::string text = "<fingerTrackingSegments" + side + " segmentCount=\"20\">\n";
  for (const HandSegment& segment : hand_segments(left)) {
    text += "<segment label=\"" + segment.name + "\"><points>";
    if (segment.finger_joint >= 0) {
      const Vec3 tip = along_mvn(fingertip_offset(left, finger_of(segment.finger_joint), 0.2));
      text += "<point label=\"pTip\"><pos_b>" + numbers({tip.x(), tip.y(), tip.z()}) +
              "</pos_b></point>";
    }
    text += "</points></segment>\n";
  }
  return text + "</fingerTrackingSegments" + side + ">\n";
}

inline std::string frame(const Skeleton& body, const Pose& pose, bool has_positions) {
  const JointTransforms world = world_transforms(body, pose);
  std::vector<double> orientations, positions;
  for (const MvnSegment& segment : mvn_segments()) {
    const Quat& q = world.rotations[segment.follows];
    const Vec3 axis = along_mvn(q.vec());
    orientations.insert(orientations.end(), {q.w(), axis.x(), axis.y(), axis.z()});
    const Vec3 place = along_mvn(world.positions[segment.follows] + q * segment.place);
    positions.insert(positions.end(), {place.x(), place.y(), place.z()});
  }
  return "<orientation>" + numbers(orientations) + "</orientation>\n" +
         (has_positions ? "<position>" + numbers(positions) + "</position>\n" : "") + "<velocity>" +
         numbers(positions) + "</velocity>\n<marker/>\n";
}

inline std::string segment(const MvnSegment& segment, const Skeleton& body, int id) {
  std::string text = "<segment label=\"" + std::string(segment.name) + "\" id=\"" +
                     std::to_string(id) + "\">\n<points>\n<point label=\"pOrigin\"><pos_b>0 0 0" +
                     "</pos_b></point>\n";
  if (const auto& tip = body.joints[segment.follows].tip) {
    const Vec3 end = along_mvn(*tip);
    text += "<point label=\"pTip\"><pos_b>" + numbers({end.x(), end.y(), end.z()}) +
            "</pos_b></point>\n";
  }
  return text + "</points>\n</segment>\n";
}

inline std::string joint(const MvnSegment& segment) {
  const std::string name = segment.joint;
  return "<joint label=\"" + name + "\"><connector1>" + segment.parent + "/" + name +
         "</connector1><connector2>" + segment.name + "/" + name + "</connector2></joint>\n";
}

}  // namespace mvnx_parts

/// The `subject` element of a clip of the canonical body, as MVN lays it out.
inline std::string mvnx_subject(const Clip& clip, const MvnxLook& look = {}) {
  using namespace mvnx_parts;
  std::string text = "<subject label=\"" + look.subject + "\" " + look.rate +
                     " segmentCount=\"23\" originalFilename=\"a.mvn\">\n";
  if (look.has_segments) {
    text += "<segments>\n";
    for (size_t s = 0; s < mvn_segments().size(); ++s)
      text += segment(mvn_segments()[s], clip.body, static_cast<int>(s) + 1);
    text += "</segments>\n";
    if (look.hands != MvnxHands::none) text += hand_segment_list(true) + hand_segment_list(false);
    text += "<sensors><sensor label=\"Pelvis\"/></sensors>\n";
  }
  if (look.has_joints) {
    text += "<joints>\n";
    for (const MvnSegment& one : mvn_segments()) text += *one.joint ? joint(one) : "";
    text += "</joints>\n";
  }
  text += "<frames segmentCount=\"23\" sensorCount=\"17\" jointCount=\"22\">\n";
  Pose rest;
  rest.root_position = {0.0, 5.0, 0.0};  // calibration frames are not part of the motion
  rest.rotations.assign(body_joint_count, Quat::Identity());
  if (look.has_calibration) {
    for (const char* type : {"identity", "tpose", "tpose-isb"})
      text += "<frame time=\"0\" index=\"\" type=\"" + std::string(type) + "\">\n" +
              frame(clip.body, rest, true) + "</frame>\n";
  }
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double time = std::floor(look.milliseconds * static_cast<double>(f));
    const std::string timed =
        look.milliseconds > 0.0 ? " time=\"" + numbers({time}) + "\"" : std::string();
    text += "<frame" + timed + " index=\"" + std::to_string(f) + "\" type=\"normal\">\n" +
            frame(clip.body, clip.poses[f], look.has_positions);
    if (look.hands != MvnxHands::none)
      text += hand_frame(clip.body, clip.poses[f], true, look.hands) +
              hand_frame(clip.body, clip.poses[f], false, look.hands);
    text += "</frame>\n";
  }
  return text + "</frames>\n</subject>\n";
}

inline std::string mvnx_document(const std::string& subjects) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<mvnx xmlns=\"http://www.xsens.com/mvn/mvnx\" version=\"4\">\n<mvn version=\"2021\"/>\n"
         "<comment>A &amp; B</comment>\n" +
         subjects + "</mvnx>\n";
}

inline std::string mvnx_text(const Clip& clip, const MvnxLook& look = {}) {
  return mvnx_document(mvnx_subject(clip, look));
}

}  // namespace mien::test
