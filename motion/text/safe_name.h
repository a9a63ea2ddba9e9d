#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/error.h"

namespace mien::motion {

// Checks of untrusted names (from a file, an archive, a request) that become names of files or
// folders. A hostile name must not lead out of the intended folder.

/// Returns why a text is not a portable name of a single file or folder, as a phrase to follow it:
/// "leads out of its folder". Empty if the name is valid. Refused are the empty name, "." and "..",
/// '/' and '\', a drive letter ("c:"), control characters, names that Windows reserves (CON,
/// nul.txt, COM1), a dot or space at the end, and more than 255 bytes.
std::string fault_of_name(std::string_view name);

/// Like fault_of_name, for a path of such names separated by '/': "frames/walk/00012.png". Absolute
/// paths are refused, and so is an empty path.
std::string fault_of_names(std::string_view path);

/// Returns why a path, as written, is invalid or leads out of its folder: it is empty, absolute,
/// contains ".." or a zero byte, or is the folder itself. Empty if it stays inside. Its names may
/// be any that this system allows, since they may be the user's own file names.
std::string fault_of_relative(std::string_view path);

/// Returns the name if it can safely be appended to a folder. Otherwise throws mien::Error with
/// `place`, the fault and the remedy.
std::string safe_component(std::string_view name, const Place& place);

/// Like safe_component, for a path of names.
std::string safe_names(std::string_view path, const Place& place);

/// Returns `folder / relative` if it lies within the folder after resolving all links: the target
/// of each link along the path must exist and lie in the folder too. Throws mien::Error otherwise.
/// Apart from links, nothing on the path need exist; `folder` may itself be a link. As in
/// fault_of_relative, names may be any that this system allows.
std::filesystem::path inside(const std::filesystem::path& folder, std::string_view relative,
                             const Place& place);

/// Whether `inside` would return. Never throws.
bool is_inside(const std::filesystem::path& folder, std::string_view relative);

}  // namespace mien::motion
