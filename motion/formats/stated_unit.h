#pragma once

#include <filesystem>
#include <optional>

namespace mien::motion {

/// Metres per unit of length that a file of joints states, where its motion is converted to metres
/// on reading: in FBX by `UnitScaleFactor`, in Acclaim files by `:units length` of the skeleton
/// (acclaim.h). None if the file states none, or is of another format. Throws mien::Error as the
/// reader of the format.
std::optional<double> stated_unit(const std::filesystem::path& path);

}  // namespace mien::motion
