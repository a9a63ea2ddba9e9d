#include "motion/measures/features/motion_features.h"

namespace mien::motion {

namespace {

using enum FeatureGroup;
using enum FeatureUnit;

struct GroupNames {
  std::string_view id;
  std::string_view english;
  std::string_view japanese;
};

constexpr std::array<GroupNames, feature_group_count> group_names = {{
    {"lateral-swing", "lateral swing of the upper body", "上半身の左右の揺れ"},
    {"front-back-swing", "front-back swing of arms and legs", "腕と脚の前後の振り"},
    {"upper-body-bend", "bending angle of the upper body", "上半身の曲げ角度"},
    {"step-length", "step length", "歩幅"},
}};

const GroupNames& names_of(FeatureGroup group) { return group_names[static_cast<size_t>(group)]; }

constexpr bool reconstructed = true;

constexpr std::array<MotionFeature, motion_feature_count> features = {{
    {"sigma-torso-lr", "side-to-side sway of the torso", "胴体の左右の揺れ", degrees,
     lateral_swing},
    {"sigma-head-lr", "side-to-side sway of the head", "頭の左右の揺れ", degrees, lateral_swing},
    {"sigma-com-pos-lr", "lateral displacement of the centre of mass", "重心の左右の揺れ", metres,
     lateral_swing, reconstructed},
    {"sigma-com-vel-lr", "side-to-side speed changes of the centre of mass",
     "重心の左右の速さの変化", metres_per_second, lateral_swing, reconstructed},
    {"sigma-torso-fb", "front-back sway of the torso", "胴体の前後の揺れ", degrees, lateral_swing},
    {"sigma-head-fb", "nodding of the head", "頭の前後の揺れ", degrees, lateral_swing},
    {"sigma-left-upper-arm-fb", "front-back swing of the left upper arm", "左上腕の前後の振り",
     degrees, front_back_swing},
    {"sigma-right-upper-arm-fb", "front-back swing of the right upper arm", "右上腕の前後の振り",
     degrees, front_back_swing},
    {"sigma-left-forearm-fb", "front-back swing of the left forearm", "左前腕の前後の振り", degrees,
     front_back_swing},
    {"sigma-right-forearm-fb", "front-back swing of the right forearm", "右前腕の前後の振り",
     degrees, front_back_swing},
    {"sigma-left-thigh-fb", "front-back swing of the left thigh", "左大腿の前後の振り", degrees,
     front_back_swing},
    {"sigma-right-thigh-fb", "front-back swing of the right thigh", "右大腿の前後の振り", degrees,
     front_back_swing},
    {"sigma-com-pos-v", "bounce of the centre of mass", "重心の上下の揺れ", metres,
     front_back_swing},
    {"sigma-com-vel-v", "up-and-down speed changes of the centre of mass", "重心の上下の速さの変化",
     metres_per_second, front_back_swing},
    {"sigma-left-thigh-lr", "sideways swing of the left thigh", "左大腿の左右の振り", degrees,
     front_back_swing},
    {"sigma-right-thigh-lr", "sideways swing of the right thigh", "右大腿の左右の振り", degrees,
     front_back_swing},
    {"sigma-left-upper-arm-lr", "sideways swing of the left upper arm", "左上腕の左右の振り",
     degrees, front_back_swing},
    {"sigma-right-upper-arm-lr", "sideways swing of the right upper arm", "右上腕の左右の振り",
     degrees, front_back_swing},
    {"mu-torso-fb", "forward bend of the torso", "胴体の前傾", degrees, upper_body_bend},
    {"mu-head-fb", "forward bend of the head", "頭の前傾", degrees, upper_body_bend},
    {"mu-left-upper-arm-fb", "left upper arm held forward", "左上腕の前への傾き", degrees,
     upper_body_bend},
    {"mu-right-upper-arm-fb", "right upper arm held forward", "右上腕の前への傾き", degrees,
     upper_body_bend},
    {"mu-left-forearm-fb", "left forearm held forward", "左前腕の前への傾き", degrees,
     upper_body_bend},
    {"mu-right-forearm-fb", "right forearm held forward", "右前腕の前への傾き", degrees,
     upper_body_bend},
    {"mu-left-thigh-fb", "left thigh held forward", "左大腿の前への傾き", degrees, upper_body_bend},
    {"mu-right-thigh-fb", "right thigh held forward", "右大腿の前への傾き", degrees,
     upper_body_bend},
    {"mu-torso-lr", "lean of the torso to the left", "胴体の左への傾き", degrees, upper_body_bend},
    {"mu-head-lr", "lean of the head to the left", "頭の左への傾き", degrees, upper_body_bend},
    {"mu-left-upper-arm-lr", "left upper arm held out", "左上腕の外への開き", degrees,
     upper_body_bend},
    {"mu-right-upper-arm-lr", "right upper arm held out", "右上腕の外への開き", degrees,
     upper_body_bend},
    {"mu-left-thigh-lr", "left thigh held out", "左大腿の外への開き", degrees, upper_body_bend},
    {"mu-right-foot-lr", "right foot turned out", "右足先の外向き", degrees, upper_body_bend},
    {"mu-com-vel-lr", "drift to the left", "左へのずれの速さ", metres_per_second, upper_body_bend},
    {"step-length-lr", "step width", "歩隔", metres, upper_body_bend},
    {"step-length-fb", "length of a step", "一歩の長さ", metres, step_length},
    {"mu-com-vel-fb", "walking speed", "歩く速さ", metres_per_second, step_length},
    {"sigma-com-vel-fb", "changes of the walking speed", "歩く速さの変化", metres_per_second,
     step_length},
    {"mu-com-pos-v", "height of the centre of mass", "重心の高さ", metres, step_length},
    {"duration", "duration of a cycle", "一周期の時間", seconds, step_length},
    {"mu-right-thigh-lr", "right thigh held out", "右大腿の外への開き", degrees, step_length},
    {"mu-left-shin-fb", "left shin held forward", "左下腿の前への傾き", degrees, step_length},
    {"mu-right-shin-fb", "right shin held forward", "右下腿の前への傾き", degrees, step_length},
    {"mu-left-foot-fb", "toes of the left foot held up", "左足先の上がり", degrees, step_length},
    {"mu-right-foot-fb", "toes of the right foot held up", "右足先の上がり", degrees, step_length},
    {"mu-left-foot-lr", "left foot turned out", "左足先の外向き", degrees, step_length},
    {"sigma-left-shin-fb", "front-back swing of the left shin", "左下腿の前後の振り", degrees,
     step_length},
    {"sigma-right-shin-fb", "front-back swing of the right shin", "右下腿の前後の振り", degrees,
     step_length},
    {"sigma-left-foot-fb", "rocking of the left foot", "左足先の上下の動き", degrees, step_length,
     reconstructed},
    {"sigma-right-foot-fb", "rocking of the right foot", "右足先の上下の動き", degrees,
     step_length},
    {"sigma-left-foot-lr", "turning of the left foot", "左足先の左右の動き", degrees, step_length},
    {"sigma-right-foot-lr", "turning of the right foot", "右足先の左右の動き", degrees,
     step_length},
}};

}  // namespace

std::string_view id_of(FeatureGroup group) { return names_of(group).id; }
std::string_view name_of(FeatureGroup group) { return names_of(group).english; }
std::string_view japanese_name_of(FeatureGroup group) { return names_of(group).japanese; }

std::string_view symbol_of(FeatureUnit unit) {
  constexpr std::string_view symbols[] = {"deg", "m", "m/s", "s"};
  static_assert(std::size(symbols) == static_cast<size_t>(FeatureUnit::seconds) + 1);
  return symbols[static_cast<size_t>(unit)];
}

const std::array<MotionFeature, motion_feature_count>& motion_features() { return features; }

int find_motion_feature(std::string_view id) {
  for (size_t i = 0; i < features.size(); ++i) {
    if (features[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace mien::motion
