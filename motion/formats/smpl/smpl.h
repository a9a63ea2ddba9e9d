#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/numpy/npz.h"
#include "motion/formats/reading/read_options.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Whether an .npz file holds rotations of SMPL joints: an array `poses`, `pose`, `root_orient` or
/// `global_orient`. Only the directory of a file and the headers of its arrays are read. Throws
/// mien::Error if it is no .npz file.
bool holds_smpl_motion(const std::filesystem::path& path);
bool holds_smpl_motion(std::string_view bytes, const std::string& file_name);

/// Reads a motion of SMPL, SMPL-H or SMPL-X (.npz), as in AMASS and BEAT2: for each of T frames the
/// rotation of each joint relative to its parent, as axis × angle (radians).
///
/// - `poses` (or `pose`), T × 3 J with J of 22, 24 (SMPL), 52 (SMPL-H) or 55 (SMPL-X), or T × J ×
///   3; else `root_orient` or `global_orient` (T × 3) and `pose_body` or `body_pose` (T × 63 or
///   69), and where there are any `pose_hand` (T × 90) or `left_hand_pose` and `right_hand_pose` (T
///   × 45), `pose_jaw` or `jaw_pose`, and `pose_eye` (T × 6) or `leye_pose` and `reye_pose`.
/// - `trans`, or `transl`, T × 3 metres. The pelvis is at trans + its rest position in the model.
///   No model is shipped, so without `options.body_model` the root is at `trans`: a constant
///   displacement, which has no effect because `to_body` puts the planted feet on the floor.
///   Without either array the figure stays in place.
/// - Rate: the `mocap_framerate`, `mocap_frame_rate`, `fps`, `frame_rate`, `framerate` or
///   `frames_per_second` of the file, which must agree within 0.1 %, else that of the options.
/// - `betas` and `gender` are noted. Offsets are those of mien's own body (smpl_joints.h), or of
///   `options.body_model` with `betas` (smpl_model.h).
///
/// A file that also has `marker_data` has the takes "body", which this reads, and "markers"
/// (read_smpl_markers).
///
/// Units are metres; axes are those of the file (+Z up in AMASS, +Y up in BEAT2), which
/// `recognise` (body_mapping.h) finds from the figure. Joints are named as in smpl_joints.h; the
/// format is "smpl".
///
/// Throws mien::Error naming file, array and frame if the layout is another, arrays differ in their
/// number of frames, numbers are not finite, no rate or contradicting rates are given, or
/// `options.take` is another than "body".
Recording read_smpl(const std::filesystem::path& path, const ReadOptions& options = {});
Recording parse_smpl(std::string_view bytes, const std::string& file_name,
                     const ReadOptions& options = {});

/// The takes of an AMASS file with markers: the motion of the body, and the markers.
inline constexpr std::string_view smpl_body_take = "body";
inline constexpr std::string_view smpl_markers_take = "markers";

/// Reads the markers of an AMASS file (.npz): `marker_data`, T × M × 3, and their names in
/// `marker_labels`. A marker at 0 0 0 or with a value that is not a number is missing. A marker
/// without a name is "marker_1", … by its place, and a second one named "LFHD" is "LFHD 2". The
/// file does not state the unit. Rate and errors as for `read_smpl`.
PointRecording read_smpl_markers(const std::filesystem::path& path,
                                 const ReadOptions& options = {});
PointRecording parse_smpl_markers(std::string_view bytes, const std::string& file_name,
                                  const ReadOptions& options = {});

/// A motion of the canonical body (body.h) in the layout of AMASS (SMPL-H): `poses` T × 156, with
/// the fingers at rest if the recording has none, `trans`, `betas` (16 zeros), `dmpls` (T × 8
/// zeros), `gender` "neutral" and `mocap_framerate`; +Z up, which was +Y. Rotations are those of
/// our joints: Spine's that of spine1, Chest's that of spine3, and spine2 does not turn. `trans` is
/// the position of the pelvis, since that of an SMPL model's pelvis at rest is not known: with a
/// model, the figure as a whole is displaced by a constant. Bone lengths are not part of this
/// format.
///
/// Throws mien::Error if the recording's joints are not those of the canonical body or it has no
/// poses. The same recording always produces the same bytes.
std::string to_amass_npz(const Recording& recording);

}  // namespace mien::motion
