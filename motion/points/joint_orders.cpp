#include "motion/points/joint_orders.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mien::motion {

namespace {

using Bone = std::pair<int, int>;

constexpr std::array<std::string_view, 24> smpl_joints = {
    "pelvis",     "left_hip",    "right_hip",    "spine1",      "left_knee",     "right_knee",
    "spine2",     "left_ankle",  "right_ankle",  "spine3",      "left_foot",     "right_foot",
    "neck",       "left_collar", "right_collar", "head",        "left_shoulder", "right_shoulder",
    "left_elbow", "right_elbow", "left_wrist",   "right_wrist", "left_hand",     "right_hand"};
constexpr std::array<Bone, 23> smpl_bones = {
    {{0, 1},   {0, 2},   {0, 3},   {1, 4},   {2, 5},   {3, 6},   {4, 7},   {5, 8},
     {6, 9},   {7, 10},  {8, 11},  {9, 12},  {9, 13},  {9, 14},  {12, 15}, {13, 16},
     {14, 17}, {16, 18}, {17, 19}, {18, 20}, {19, 21}, {20, 22}, {21, 23}}};

constexpr std::array<std::string_view, 17> h36m_joints = {
    "pelvis",     "right_hip",  "right_knee",     "right_ankle", "left_hip",   "left_knee",
    "left_ankle", "spine",      "thorax",         "nose",        "head",       "left_shoulder",
    "left_elbow", "left_wrist", "right_shoulder", "right_elbow", "right_wrist"};
constexpr std::array<Bone, 16> h36m_bones = {{{0, 1},
                                              {1, 2},
                                              {2, 3},
                                              {0, 4},
                                              {4, 5},
                                              {5, 6},
                                              {0, 7},
                                              {7, 8},
                                              {8, 9},
                                              {9, 10},
                                              {8, 11},
                                              {11, 12},
                                              {12, 13},
                                              {8, 14},
                                              {14, 15},
                                              {15, 16}}};

constexpr std::array<std::string_view, 25> kinect_joints = {
    "spine_base",     "spine_mid",     "neck",       "head",           "left_shoulder",
    "left_elbow",     "left_wrist",    "left_hand",  "right_shoulder", "right_elbow",
    "right_wrist",    "right_hand",    "left_hip",   "left_knee",      "left_ankle",
    "left_foot",      "right_hip",     "right_knee", "right_ankle",    "right_foot",
    "spine_shoulder", "left_hand_tip", "left_thumb", "right_hand_tip", "right_thumb"};
constexpr std::array<Bone, 24> kinect_bones = {
    {{0, 1},  {1, 20},  {20, 2},  {2, 3},   {20, 4}, {4, 5},   {5, 6},   {6, 7},
     {20, 8}, {8, 9},   {9, 10},  {10, 11}, {0, 12}, {12, 13}, {13, 14}, {14, 15},
     {0, 16}, {16, 17}, {17, 18}, {18, 19}, {7, 21}, {6, 22},  {11, 23}, {10, 24}}};

constexpr std::array<std::string_view, 25> body_25_joints = {
    "nose",           "neck",        "right_shoulder", "right_elbow",     "right_wrist",
    "left_shoulder",  "left_elbow",  "left_wrist",     "mid_hip",         "right_hip",
    "right_knee",     "right_ankle", "left_hip",       "left_knee",       "left_ankle",
    "right_eye",      "left_eye",    "right_ear",      "left_ear",        "left_big_toe",
    "left_small_toe", "left_heel",   "right_big_toe",  "right_small_toe", "right_heel"};
constexpr std::array<Bone, 24> body_25_bones = {
    {{1, 8},  {1, 2},   {2, 3},   {3, 4},   {1, 5},   {5, 6},   {6, 7},   {8, 9},
     {9, 10}, {10, 11}, {8, 12},  {12, 13}, {13, 14}, {1, 0},   {0, 15},  {15, 17},
     {0, 16}, {16, 18}, {14, 19}, {19, 20}, {14, 21}, {11, 22}, {22, 23}, {11, 24}}};

constexpr std::array<std::string_view, 33> mediapipe_joints = {
    "nose",        "left_eye_inner",  "left_eye",        "left_eye_outer", "right_eye_inner",
    "right_eye",   "right_eye_outer", "left_ear",        "right_ear",      "mouth_left",
    "mouth_right", "left_shoulder",   "right_shoulder",  "left_elbow",     "right_elbow",
    "left_wrist",  "right_wrist",     "left_pinky",      "right_pinky",    "left_index",
    "right_index", "left_thumb",      "right_thumb",     "left_hip",       "right_hip",
    "left_knee",   "right_knee",      "left_ankle",      "right_ankle",    "left_heel",
    "right_heel",  "left_foot_index", "right_foot_index"};

constexpr std::array<JointOrder, 6> orders = {{
    {"humanml3d", std::span(smpl_joints).first(22), std::span(smpl_bones).first(21)},
    {"smpl", smpl_joints, smpl_bones},
    {"h36m", h36m_joints, h36m_bones},
    {"kinect", kinect_joints, kinect_bones},
    {"body_25", body_25_joints, body_25_bones},
    {"mediapipe", mediapipe_joints, {}},
}};

}  // namespace

std::span<const JointOrder> joint_orders() { return orders; }

const JointOrder* joint_order(std::string_view name) {
  const auto found = std::find_if(orders.begin(), orders.end(),
                                  [&](const JointOrder& order) { return order.name == name; });
  return found == orders.end() ? nullptr : &*found;
}

std::vector<std::string> given_point_names(const std::vector<std::string>& given) {
  const JointOrder* const order = given.size() == 1 ? joint_order(given.front()) : nullptr;
  if (order == nullptr) return given;
  return {order->joints.begin(), order->joints.end()};
}

}  // namespace mien::motion
