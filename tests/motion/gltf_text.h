#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace mien::test {

inline std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

/// Buffer, buffer views and accessors of a hand-made glTF file: one view and one accessor for each
/// list of numbers.
class GltfNumbers {
 public:
  /// Adds 32-bit floats ("SCALAR", "VEC3", "VEC4"); returns the accessor's index.
  int add(const std::vector<float>& numbers, const std::string& type) {
    return add(numbers, type, 5126, false);
  }

  template <typename T>
  int add(const std::vector<T>& numbers, const std::string& type, int component, bool normalised) {
    const std::string at = std::to_string(bytes_.size());
    const size_t size = numbers.size() * sizeof(T);
    const size_t width = type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    views_ += std::string(count_ ? "," : "") + R"({"buffer":0,"byteOffset":)" + at +
              R"(,"byteLength":)" + std::to_string(size) + "}";
    accessors_ += std::string(count_ ? "," : "") + R"({"bufferView":)" + std::to_string(count_) +
                  R"(,"componentType":)" + std::to_string(component) + R"(,"normalized":)" +
                  (normalised ? "true" : "false") + R"(,"count":)" +
                  std::to_string(numbers.size() / width) + R"(,"type":")" + type + "\"}";
    return count_++;
  }

  /// The members of the document that hold the numbers.
  std::string json() const {
    return R"("buffers":[{"byteLength":)" + std::to_string(bytes_.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes_) +
           R"("}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ + "]";
  }

 private:
  std::string bytes_;
  std::string views_;
  std::string accessors_;
  int count_ = 0;
};

/// A whole document: nodes (and skins) as JSON, channels and samplers of the animation as JSON.
inline std::string gltf_text(const GltfNumbers& numbers, const std::string& nodes,
                             const std::string& channels, const std::string& samplers) {
  return R"({"asset":{"version":"2.0"},)" + nodes + R"(,"animations":[{"channels":[)" + channels +
         R"(],"samplers":[)" + samplers + "]}]," + numbers.json() + "}";
}

/// One channel that moves a part ("rotation") of a node by a sampler.
inline std::string gltf_channel(int sampler, int node, const std::string& path) {
  return R"({"sampler":)" + std::to_string(sampler) + R"(,"target":{"node":)" +
         std::to_string(node) + R"(,"path":")" + path + "\"}}";
}

inline std::string gltf_sampler(int input, int output, const std::string& interpolation) {
  return R"({"input":)" + std::to_string(input) + R"(,"output":)" + std::to_string(output) +
         R"(,"interpolation":")" + interpolation + "\"}";
}

}  // namespace mien::test
