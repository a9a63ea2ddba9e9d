#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/formats/reading/read_options.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// Reads the figure and one motion of an FBX file of version 6.1 to 7.7, binary or text.
///
/// - The motion (animation stack or take) is the one named by `options.take`, or else the first one
///   that moves the figure. `takes` lists all of the file. If none moves the figure, or there is
///   none, there is one frame.
/// - The skeleton consists of the models that are limbs or that skins are bound to, and those
///   between them (fbx_figure.h); without any, of the models that the motion moves. Of several
///   figures, the one with the most joints is used, and `notes` says so. Names differ: a second
///   "Hips" is "Hips 2". Ends of bones such as "HeadTop_End" are tips.
/// - Positions are in metres (`UnitScaleFactor` is the number of centimetres in a unit) with +Y up
///   and the front towards +Z, turned from the axes that the file states.
/// - World positions are exact for any scales, pivots and kinds of inheritance: models above the
///   root become part of the root's pose, and scales and pivots part of the offsets. Poses get
///   `offsets` only if a joint moves relative to its parent by more than a millionth of the longest
///   offset.
/// - Curves are constant, linear or cubic (fbx_curve.h). Layers above the first are added to or
///   override what is below; the motion is then noted as blended, as programs differ in details.
/// - Frames extend from the first key to the last, within the span that the take states. Their rate
///   is that of the keys if those of the curve with the most keys
///   (at least eight) are evenly spaced at ten or more per second and more than the file's time
///   mode, else that of the time mode, else that of the keys, `options.frames_per_second` or 30.
///
/// Sources: the layout as in fbx_document.h; the meaning of transforms, inheritance and time modes
/// after Autodesk's documentation of the FBX SDK, verified on the geometry of published test files.
///
/// Throws mien::Error with the byte (binary) or line and column (text) if the file is damaged, of
/// another version, or holds no figure, if the take does not exist, or if the motion is longer than
/// an hour.
Recording read_fbx(const std::filesystem::path& path, const ReadOptions& options = {});

/// As `read_fbx`, for a file in memory; `file_name` is used in error messages and, without folder
/// and extension, as the name of the recording.
Recording parse_fbx(std::string_view bytes, const std::string& file_name,
                    const ReadOptions& options = {});

}  // namespace mien::motion
