#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/formats/gltf_library.h"

namespace mien::motion {

/// Whether a buffer is a placeholder (`fallback` of EXT_meshopt_compression): the uncompressed
/// bytes of its buffer views, for readers without the extension. It may have no bytes, and need not
/// be loaded.
bool is_meshopt_fallback(const nlohmann::json& buffer);

/// Decompresses the buffer views of a glTF document that use EXT_meshopt_compression or
/// KHR_meshopt_compression. Each gets a buffer of its own at the end of `buffers`, to which
/// `document` then refers. `name`: the file's, for messages. Throws mien::Error naming the file if
/// a view is damaged or compressed in an unknown mode.
void unpack_meshopt(nlohmann::json& document, std::vector<tinygltf::Buffer>& buffers,
                    const std::string& name);

}  // namespace mien::motion
