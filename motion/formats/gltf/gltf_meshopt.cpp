#include "motion/formats/gltf/gltf_meshopt.h"

#include <array>
#include <span>

#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

using nlohmann::json;
using Bytes = std::span<const unsigned char>;

constexpr std::array extensions = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr size_t most_bytes = size_t{1} << 29;  // of one view: few bytes may stand for very many

/// What a buffer or a buffer view says of its compression; null when it says nothing.
const json& compression_of(const json& entry) {
  static const json nothing;
  if (!entry.is_object()) return nothing;
  const auto all = entry.find("extensions");
  if (all == entry.end() || !all->is_object()) return nothing;
  for (const char* extension : extensions) {
    const auto found = all->find(extension);
    if (found != all->end() && found->is_object()) return *found;
  }
  return nothing;
}

/// One compressed view.
struct Packed {
  const json& given;
  const std::string& name;
  std::string use;  ///< "buffer view 3"

  [[noreturn]] void refuse(const std::string& wrong) const {
    throw Error({name}, use + ", compressed by meshopt: " + wrong,
                "unpack it with gltf-transform, or export it uncompressed");
  }

  size_t number(const char* key, size_t otherwise) const {
    const auto found = given.find(key);
    if (found == given.end()) return otherwise;
    if (!found->is_number_unsigned()) refuse(std::string(key) + " is no number");
    return found->get<size_t>();
  }

  std::string word(const char* key, const char* otherwise) const {
    const auto found = given.find(key);
    return found != given.end() && found->is_string() ? found->get<std::string>() : otherwise;
  }

  Bytes bytes(const std::vector<tinygltf::Buffer>& buffers) const {
    const size_t buffer = number("buffer", buffers.size());
    if (buffer >= buffers.size()) refuse("there is no such buffer");
    const Bytes all(buffers[buffer].data);
    const size_t offset = number("byteOffset", 0);
    const size_t length = number("byteLength", 0);
    if (offset > all.size() || length > all.size() - offset) refuse("it reaches beyond its buffer");
    return all.subspan(offset, length);
  }
};

/// Checks sizes, which the library does not check itself.
void check_sizes(const Packed& packed, const std::string& mode, size_t count, size_t stride) {
  const bool is_vertices = mode == "ATTRIBUTES";
  const bool is_indices = mode == "TRIANGLES" || mode == "INDICES";
  if (!is_vertices && !is_indices) packed.refuse("mode " + excerpt(mode) + " is not known");
  const bool fits =
      is_vertices ? stride > 0 && stride <= 256 && stride % 4 == 0 : stride == 2 || stride == 4;
  if (!fits) packed.refuse("byteStride " + std::to_string(stride) + " does not fit its mode");
  if (count > most_bytes / stride) packed.refuse("it holds too many elements");
  if (mode == "TRIANGLES" && count % 3 != 0) packed.refuse("triangles have three corners");
}

int decode(const std::string& mode, Bytes bytes, size_t count, size_t stride,
           unsigned char* decoded) {
  if (mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(decoded, count, stride, bytes.data(), bytes.size());
  }
  if (mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(decoded, count, stride, bytes.data(), bytes.size());
  }
  return meshopt_decodeIndexSequence(decoded, count, stride, bytes.data(), bytes.size());
}

void filter(const Packed& packed, const std::string& kind, size_t count, size_t stride,
            unsigned char* decoded) {
  if (kind == "NONE") return;
  if (kind == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
    meshopt_decodeFilterOct(decoded, count, stride);
  } else if (kind == "QUATERNION" && stride == 8) {
    meshopt_decodeFilterQuat(decoded, count, stride);
  } else if (kind == "EXPONENTIAL" && stride % 4 == 0) {
    meshopt_decodeFilterExp(decoded, count, stride);
  } else {
    packed.refuse("filter " + kind + " is not known for elements of " + std::to_string(stride) +
                  " bytes");
  }
}

std::vector<unsigned char> unpacked(const Packed& packed,
                                    const std::vector<tinygltf::Buffer>& buffers) {
  const std::string mode = packed.word("mode", "");
  const size_t count = packed.number("count", 0);
  const size_t stride = packed.number("byteStride", 0);
  check_sizes(packed, mode, count, stride);
  std::vector<unsigned char> decoded(count * stride);
  if (count == 0) return decoded;
  if (decode(mode, packed.bytes(buffers), count, stride, decoded.data()) != 0) {
    packed.refuse("its bytes are damaged or from a newer version");
  }
  filter(packed, packed.word("filter", "NONE"), count, stride, decoded.data());
  return decoded;
}

}  // namespace

bool is_meshopt_fallback(const nlohmann::json& buffer) {
  const json& compression = compression_of(buffer);
  return compression.is_object() && compression.value("fallback", json()) == true;
}

void unpack_meshopt(nlohmann::json& document, std::vector<tinygltf::Buffer>& buffers,
                    const std::string& name) {
  const auto views = document.find("bufferViews");
  if (views == document.end() || !views->is_array()) return;
  size_t total = 0;
  for (size_t i = 0; i < views->size(); ++i) {
    json& view = (*views)[i];
    const json compression = compression_of(view);
    if (view.is_object()) view.erase("extensions");
    if (!compression.is_object()) continue;
    const Packed packed{compression, name, "buffer view " + std::to_string(i)};
    tinygltf::Buffer buffer;
    buffer.data = unpacked(packed, buffers);
    total += buffer.data.size();
    if (total > most_bytes) packed.refuse("it holds too many elements");
    view["buffer"] = buffers.size();
    view["byteOffset"] = 0;
    view["byteLength"] = buffer.data.size();
    buffers.push_back(std::move(buffer));
  }
}

}  // namespace mien::motion
