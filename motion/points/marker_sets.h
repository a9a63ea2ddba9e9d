#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// What a point of a recording marks: a joint centre of the canonical body (body.h), another centre
/// inside the body, or a place on the skin.
enum class Landmark {
  // Joint centres as the canonical body has them.
  pelvis,
  spine,
  chest,
  neck,
  head,
  clavicle,
  shoulder,
  elbow,
  wrist,
  hip,
  knee,
  ankle,
  toe,
  // Other centres and ends.
  mid_hips,
  mid_shoulders,
  head_centre,
  head_top,
  hand,
  toe_tip,
  // Places on the head.
  nose,
  eye,
  ear,
  mouth,
  head_front,
  head_back,
  head_side,
  // Places on the trunk.
  front_iliac_spine,
  back_iliac_spine,
  sacrum,
  iliac_crest,
  acromion,
  cervical_7,
  back,   ///< on the spine, at the height of the lowest ribs
  trunk,  ///< elsewhere on the chest or back
  jugular_notch,
  sternum,
  // Places on the arm.
  upper_arm,
  outer_elbow,
  inner_elbow,
  forearm,
  thumb_side_of_wrist,
  finger_side_of_wrist,
  // Places on the leg.
  trochanter,
  thigh,
  outer_knee,
  inner_knee,
  shank,
  outer_ankle,
  inner_ankle,
  heel,
  first_metatarsal,
  second_metatarsal,
  fifth_metatarsal,
  foot,
};

enum class Side { middle, left, right };

/// The role of a point: what it marks, and on which side of the body.
struct Role {
  Landmark landmark;
  Side side;
  bool operator==(const Role&) const = default;
};

/// A set of markers or joint centres, recognised by the names of the points.
struct MarkerSet {
  std::string name;                         ///< "Plug-in Gait"; empty if no set is recognised
  std::vector<std::optional<Role>> roles;   ///< of each point; none if the name is unknown
  std::vector<std::string> missing_points;  ///< of the set, in its own spelling: "LTHI"
  std::vector<std::string>
      missing_parts;  ///< which a body needs: "left knee"; empty: can be fitted

  /// The points of a role in the order of the file; often one or none.
  std::vector<int> points_of(Landmark landmark, Side side) const;
};

/// Finds the set whose names the points carry most, ignoring case, separators ("L_ASI", "L.ASI"), a
/// subject ("Name:LASI") and a beginning that all points share ("Name_LASI"). Names that several
/// sets use for additional points, such as joint centres ("LHJC") and inner knee markers ("LMKNE"),
/// are recognised in every set. The table of names is in marker_names.cpp.
///
/// Joints by the names of a rig ("LeftUpLeg", "UpperLeg_L") are a set as well, "joints of a rig",
/// if that identifies more points than any set of the table (rig_joint_roles.h).
///
/// A name is not enough: a set is recognised if four of its names are there.
MarkerSet recognised_marker_set(std::span<const std::string> points);

/// "left knee, outer side": a role in words.
std::string words_for(const Role& role);

}  // namespace mien::motion
