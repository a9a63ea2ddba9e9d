#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "motion/formats/motion_format.h"
#include "motion/points/point_recording.h"
#include "motion/skeleton/recording.h"
#include "motion/text/result_files.h"

namespace mien::motion {

/// The format in which a file of this name is written. Throws mien::Error naming the formats that
/// are written if it is none of them, is compressed, or has a name that the format does not allow.
const MotionFormat& written_format(const std::filesystem::path& path);

/// The files that would be written beside a motion file of this name, whether or not they exist.
/// Empty if its format is not written.
std::vector<std::filesystem::path> companion_files(const std::filesystem::path& path);

/// The files that are written for a motion file: itself, and those that belong beside it, such as
/// the description of a table. Throws as `written_format`.
std::vector<std::filesystem::path> written_files(const std::filesystem::path& path);

/// The same files with their bytes. In formats of points, a motion's joints are written
/// (joint_points.h). A recording for a format that is metric is in metres with +Y up, one for a
/// format of the canonical body has that body. Throws as `written_format`, and if the format has no
/// place for the recording.
std::vector<ResultBytes> motion_files(const Recording& recording,
                                      const std::filesystem::path& path);

/// As above, for points as they were recorded, in their own unit and axes and with their gaps. The
/// format holds points.
std::vector<ResultBytes> point_files(const PointRecording& points,
                                     const std::filesystem::path& path);

}  // namespace mien::motion
