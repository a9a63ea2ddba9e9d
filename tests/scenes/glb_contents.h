#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::test {

/// What a GLB file holds, read by its own rules.
struct GlbContents {
  nlohmann::json json;
  std::string binary;

  /// The numbers of an accessor: floats, or unsigned integers of two or four bytes.
  std::vector<double> numbers(const nlohmann::json& accessor_index) const {
    const nlohmann::json& accessor = json.at("accessors").at(accessor_index.get<std::size_t>());
    const int type = accessor.at("componentType");
    if (!accessor.contains("sparse")) return numbers_in(accessor.at("bufferView"), type);
    const nlohmann::json& sparse = accessor.at("sparse");
    const std::vector<double> places = numbers_in(sparse.at("indices").at("bufferView"),
                                                  sparse.at("indices").at("componentType")),
                              values = numbers_in(sparse.at("values").at("bufferView"), type);
    const std::size_t components = values.size() / places.size();
    std::vector<double> whole(accessor.at("count").get<std::size_t>() * components, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
      whole.at(static_cast<std::size_t>(places[i / components]) * components + i % components) =
          values[i];
    return whole;
  }

  std::string file(const nlohmann::json& view_index) const {
    const nlohmann::json& view = json.at("bufferViews").at(view_index.get<std::size_t>());
    return binary.substr(view.at("byteOffset"), view.at("byteLength"));
  }

 private:
  std::vector<double> numbers_in(const nlohmann::json& view_index, int type) const {
    const nlohmann::json& view = json.at("bufferViews").at(view_index.get<std::size_t>());
    const std::size_t size = type == 5123 ? 2 : 4,
                      count = view.at("byteLength").get<std::size_t>() / size;
    const char* from = binary.data() + view.at("byteOffset").get<std::size_t>();
    std::vector<double> read;
    for (std::size_t i = 0; i < count; ++i, from += size)
      read.push_back(type == 5126   ? value<float>(from)
                     : type == 5125 ? value<std::uint32_t>(from)
                                    : value<std::uint16_t>(from));
    return read;
  }

  template <class Number>
  static double value(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
  }
};

/// Parses a GLB file. Throws std::invalid_argument if it is not one or its lengths do not agree.
inline GlbContents glb_contents(const std::string& file) {
  const auto word = [&](std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, file.substr(at, 4).data(), 4);
    return number;
  };
  const std::size_t json = word(12), binary = word(20 + json);
  if (file.substr(0, 4) != "glTF" || word(4) != 2 || word(8) != file.size() ||
      file.size() != 28 + json + binary)
    throw std::invalid_argument("no GLB file");
  return {nlohmann::json::parse(file.substr(20, json)), file.substr(28 + json)};
}

}  // namespace mien::test
