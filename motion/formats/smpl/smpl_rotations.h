#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/numpy/npz.h"

namespace mien::motion {

/// The rotations of SMPL joints over time, as in a file.
struct SmplRotations {
  std::size_t frames = 0;
  std::size_t joints = 0;  ///< 22, 24, 52 or 55 (smpl_joints.h)
  /// Axis × angle, radians: three numbers a joint, joint by joint and frame by frame.
  std::vector<double> axis_angles;
};

/// Names of the arrays that hold rotations.
std::vector<std::string_view> smpl_rotation_arrays();

/// Whether the file holds rotations of SMPL joints.
bool has_smpl_rotations(const Npz& npz);

/// The rotations, from one array or from several (smpl.h); `notes` gets a sentence about hands that
/// are left at rest. Throws mien::Error.
SmplRotations smpl_rotations(const Npz& npz, std::vector<std::string>& notes);

/// Throws mien::Error, naming the frame, unless all numbers are finite and below 10¹².
void require_finite(const NpyArray& array, const std::vector<double>& numbers,
                    const std::string& file);

}  // namespace mien::motion
