#pragma once

#include <string_view>

namespace mien::motion {

/// Throws mien::Error, naming the file, when its bytes are plainly those of something else than
/// its name says: nothing, UTF-16 text, a picture, a web page, an archive, another kind of motion.
/// One sentence for each, with what to do. Bytes that are none of these are left to the reader.
/// `format` is that of the reader (Recording::format): "bvh", "amc", "gltf".
void require_kind(std::string_view bytes, std::string_view file, std::string_view format);

}  // namespace mien::motion
