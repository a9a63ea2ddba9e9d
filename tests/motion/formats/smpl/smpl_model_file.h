#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "motion/formats/numpy/numpy_files.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/math/geometry.h"

namespace mien::test {

/// A model of SMPL-H whose person is mien's own body times `scale`, whatever the shape
/// coefficients: each vertex is a joint.
inline std::string smpl_model_of_size(double scale) {
  constexpr std::size_t joints = 52;
  const motion::Skeleton skeleton = motion::smpl_skeleton(joints);
  std::vector<motion::Vec3> places;
  std::vector<double> vertices, regressor(joints * joints, 0.0), tree;
  for (std::size_t j = 0; j < joints; ++j) {
    const motion::Joint& joint = skeleton.joints[j];
    motion::Vec3 place = scale * joint.offset;
    if (joint.parent >= 0) place += places[static_cast<std::size_t>(joint.parent)];
    places.push_back(place);
    vertices.insert(vertices.end(), place.begin(), place.end());
    regressor[j * joints + j] = 1.0;
    tree.push_back(joint.parent);
  }
  for (std::size_t j = 0; j < joints; ++j) tree.push_back(static_cast<double>(j));
  return npz_file({{"v_template", npy_f8("(52, 3)", vertices)},
                   {"shapedirs", npy_f8("(52, 3, 1)", std::vector<double>(3 * joints, 0.0))},
                   {"J_regressor", npy_f8("(52, 52)", regressor)},
                   {"kintree_table", npy_f8("(2, 52)", tree)}});
}

}  // namespace mien::test
