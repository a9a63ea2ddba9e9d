#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Reads joint positions from a NumPy array of T × J × 3 (.npy), or from the only such array of an
/// .npz file; an extent of 1 may stand before. A point with a value that is not a number is missing
/// in that frame.
///
/// - Names: `options.joints`, J of them or the name of one known order (joint_orders.h). Otherwise
///   those in an array of J texts in the same .npz file (names, joint_names, labels, marker_labels,
///   marker_names or keypoints), if they all differ. Otherwise by J: 22 HumanML3D, 24 SMPL, 17
///   Human3.6M, 33 MediaPipe, which is noted. Of the two known orders of 25, Kinect and BODY_25, it
///   is the one whose bones keep their lengths better over the frames and are shorter, if that is
///   clear.
/// - Rate: that stated in an .npz file, else that of the options (array_rate.h). 22 joints without
///   names otherwise have 20 Hz, HumanML3D's rate, and metres, which is noted.
///
/// Throws mien::Error, naming the array and its shape, for arrays of HumanML3D or KIT-ML features
/// (T × 263, T × 251), two-dimensional positions (T × J × 2), other shapes, Python objects, numbers
/// of joints whose order is not known, and files without a rate.
/// Beside an .npy file, a description may lie (npy_description.h), which states names, frame rate
/// and unit as far as the options do not; a note says so.
PointRecording read_npy_positions(const std::filesystem::path& path,
                                  const ReadOptions& options = {});

/// As above, for an .npz file, of which only the positions and the rate are read.
PointRecording read_npz_positions(const std::filesystem::path& path,
                                  const ReadOptions& options = {});

/// As above, for an .npy or .npz file in memory.
PointRecording parse_npy_positions(std::string_view bytes, const std::string& file_name,
                                   const ReadOptions& options = {});

/// The points as an .npy file: T × J × 3 numbers of 32 bits, in metres, or as they are if their
/// unit is not known; NaN where a point is missing. Names and the frame rate have no place in it
/// (npy_description.h).
std::string to_positions_npy(const PointRecording& recording);

}  // namespace mien::motion
