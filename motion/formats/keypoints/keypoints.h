#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Largest JSON file of keypoints that is read, bytes; in memory it takes several times as much.
inline constexpr std::size_t max_keypoint_bytes = std::size_t{256} << 20;

/// Reads positions in space that were found in videos, from JSON. Layouts:
///
/// - OpenPose: `people[].pose_keypoints_3d`, x, y, z and confidence of each point in turn; 25
///   points are BODY_25, 18 are COCO. A confidence of 0 is missing. The unit is that of the
///   calibration, which the file does not state.
/// - MediaPipe: frames as lists of landmarks {x, y, z, visibility}, or as objects that hold such a
///   list (or one for each person) as `pose_world_landmarks`, `worldLandmarks`, `landmarks`,
///   `keypoints3D` …; 33 landmarks are those of the pose. World landmarks are in metres, +Y down.
///   Landmarks of the picture are read with a note, because they are not to scale.
/// - FreeMoCap (`…_by_frame.json`): `data_by_frame`, an object for each frame with
///   `tracked_points`, or in older versions `body`, `left_hand` and `right_hand`, of points {x, y,
///   z}; millimetres.
///
/// Files of OpenPose and MediaPipe hold a list of frames, or an object with the list as `frames`
/// and perhaps `fps`, or a single frame. Frames may state their number and time
/// (column_name.h). FreeMoCap's times have no stated unit and are not read. Other numbers of points
/// take their names from the landmarks, or from `options.joints`.
///
/// OpenPose writes each frame to a separate file: the folder of these files is read as one
/// recording, and so is any of them, with a note (keypoint_frames.h). Frames that are missing in
/// the numbering are gaps.
///
/// Several people are `subjects`; the first is read, with a note, unless the options choose
/// another. A person of OpenPose is known by `person_id`, or else by the place in the list.
///
/// Source: OpenPose's doc/02_output.md, MediaPipe's pose landmarker guide, and FreeMoCap's
/// data_saver.py (as quoted in public repositories).
///
/// Throws mien::Error naming the file (for JSON faults with line and column, otherwise with the
/// number of the frame) for two-dimensional keypoints, an unknown layout, and no frame rate.
PointRecording read_keypoints(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_keypoints`, for a text in memory.
PointRecording parse_keypoints(std::string_view json, const std::string& file_name,
                               const ReadOptions& options = {});

}  // namespace mien::motion
