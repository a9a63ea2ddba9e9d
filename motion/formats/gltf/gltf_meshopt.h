#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/formats/gltf/gltf_library.h"

namespace mien::motion {

/// Whether a buffer is a fallback (`fallback` of EXT_meshopt_compression), intended only for
/// readers without the extension: it contains the uncompressed bytes of its buffer views, or
/// nothing. It need not be loaded.
bool is_meshopt_fallback(const nlohmann::json& buffer);

/// Decompresses the buffer views of a glTF document that use EXT_meshopt_compression or
/// KHR_meshopt_compression. Each one gets its own buffer at the end of `buffers`, to which
/// `document` then refers. `name` is the name of the file. Throws mien::Error naming the file if a
/// view is damaged or uses an unknown compression mode.
void unpack_meshopt(nlohmann::json& document, std::vector<tinygltf::Buffer>& buffers,
                    const std::string& name);

}  // namespace mien::motion
