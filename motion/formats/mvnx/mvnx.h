#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads an MVNX file (Xsens MVN: XML with `subject`, `segments`, `joints` and `frames`, versions 3
/// and 4): metres, Z up, at rest facing +X in a T-pose, as segment frames are defined by MVN.
///
/// - Each segment is a joint at the segment's origin. Its parent is that of `joints` (connectors
///   such as "Pelvis/jL5S1"); without them, that of MVN's own 23 segments, whose order is also used
///   where a file of 23 lacks `segments`. Segments on no joint (props) are left out.
/// - Frames are those of type "normal": `orientation` (w x y z a segment, in the world) and
///   `position` (x y z a segment, metres). Frames of calibration poses are passed over.
/// - Tracked fingers (`orientationFingersLeft`, `positionFingersRight`, …) are joints below the
///   hands, named as in `fingerTrackingSegmentsLeft` or in MVN's order ("LeftCarpus",
///   "LeftFirstMC", …); their parents are those of MVN's hands.
/// - An offset is the median over the frames of a segment's position in the frame of its parent.
///   `notes` tells where positions differ from that by more than 1 cm.
/// - The tip of the last segment of a chain is the farthest of its `points`.
/// - The frame rate is `frameRate`. If the frames' `time` (milliseconds) contradicts it or it is
///   missing, `time` is used, and `notes` says so; without both, `options.frames_per_second`.
/// - Of several subjects, `options.subject` chooses one by label or number, else the first is read
///   and `notes` says so.
///
/// Throws mien::Error with file, line and column for what is not well-formed XML, declares a
/// document type (which could define entities), or is no MVNX motion: without positions or frames,
/// with more or fewer numbers than segments, or numbers that are not finite.
Recording read_mvnx(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_mvnx`, for a text in memory; `file_name` is used in error messages and, without folder
/// and extension, as the name of the recording.
Recording parse_mvnx(std::string_view text, const std::string& file_name,
                     const ReadOptions& options = {});

}  // namespace mien::motion
