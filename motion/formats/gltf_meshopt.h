#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "motion/formats/gltf_library.h"

namespace mien::motion {

/// Whether a buffer is only the fallback of compressed buffer views (`fallback` of
/// EXT_meshopt_compression), which may have no bytes.
bool is_meshopt_fallback(const nlohmann::json& buffer);

/// Unpacks the buffer views of a glTF document that are compressed by EXT_meshopt_compression or
/// KHR_meshopt_compression: each gets a buffer of its own at the end of `buffers`. Throws
/// mien::Error naming the file when one is damaged, or packed in a way that is not known here.
void unpack_meshopt(nlohmann::json& document, std::vector<tinygltf::Buffer>& buffers,
                    const std::string& name);

}  // namespace mien::motion
