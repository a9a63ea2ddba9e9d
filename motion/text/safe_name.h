#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/error.h"

namespace mien::motion {

// Names that somebody else wrote (in a file, an archive, a request) and that become files or
// folders of ours. A hostile one must lead nowhere but into the folder that is meant.

/// Why a text is not the name of one file or folder on any system, in words that follow it: "leads
/// out of its folder". Empty when it is. Refused are the empty name, "." and "..", '/' and '\', a
/// drive letter ("c:"), control characters, names that Windows reserves (CON, nul.txt, COM1), a dot
/// or space at the end, and more than 255 bytes.
std::string fault_of_name(std::string_view name);

/// As fault_of_name, for a path of such names separated by '/': "frames/walk/00012.png". Absolute
/// paths are refused, and so is an empty path.
std::string fault_of_names(std::string_view path);

/// Why a path leads out of its folder as it is written, or is none: empty, absolute, with "..",
/// with a zero byte, or the folder itself. Empty when it stays inside. Names in it may be any that
/// this system allows, as those of files that the user has named.
std::string fault_of_relative(std::string_view path);

/// The name, which is fit to be appended to a folder. Throws mien::Error, with the place that gave
/// it, what is wrong and how to mend it.
std::string safe_component(std::string_view name, const Place& place);

/// As safe_component, for a path of names.
std::string safe_names(std::string_view path, const Place& place);

/// `folder / relative`, where that lies in the folder however it is written and whatever links lead
/// to: each link on the way must end in the folder. The file need not be there; `folder` may itself
/// be a link. Unlike the names above, those of `relative` may be any that this system allows.
/// Throws mien::Error.
std::filesystem::path inside(const std::filesystem::path& folder, std::string_view relative,
                             const Place& place);

/// Whether `inside` would return. Never throws.
bool is_inside(const std::filesystem::path& folder, std::string_view relative);

}  // namespace mien::motion
