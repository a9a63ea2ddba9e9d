#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "motion/formats/smpl/smpl_joints.h"

namespace mien::motion {

/// The joints of `skeleton` (smpl_skeleton) at rest according to an SMPL model file of the user,
/// for a person of these shape coefficients:
///
///   joints = J_regressor · (v_template + Σₖ betasₖ · shapedirs[:, :, k])    (Loper 2015, eq. 8–10)
///
/// The model is an .npz with `v_template` (V × 3), `shapedirs` (V × 3 × K), `J_regressor` (J × V)
/// and `kintree_table` (2 × J, parents in the first row; the root's is negative or 2³² − 1), for J
/// of 24, 52 or 55. Coefficients beyond K are not used. Offsets are replaced, and tips removed; the
/// root's offset is the pelvis at rest.
///
/// Throws mien::Error if the model is no such file, if its joints are not those of SMPL, or if it
/// lacks a joint of the skeleton (fingers in an SMPL model).
void set_smpl_proportions(Skeleton& skeleton, const std::filesystem::path& model,
                          std::span<const double> betas);

/// As above, for a model in memory.
void set_smpl_proportions(Skeleton& skeleton, std::string_view model, const std::string& file_name,
                          std::span<const double> betas);

}  // namespace mien::motion
