// The library's code needs a header that it includes only when it may open files.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/gltf/gltf_humanoid.h"
#include "motion/formats/gltf/gltf_library.h"
#include "motion/formats/gltf/gltf_meshopt.h"
#include "motion/formats/gltf/gltf_track.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;

/// The two parts of a binary glTF file, or a text file as a whole.
struct Container {
  std::string_view json;
  std::optional<std::string_view> binary;
};

std::uint32_t word_at(std::string_view bytes, size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

Container parse_container(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with("glTF")) return {bytes, std::nullopt};
  constexpr std::uint32_t json_chunk = 0x4E4F534A;
  constexpr std::uint32_t binary_chunk = 0x004E4942;
  constexpr size_t header = 12;
  constexpr size_t chunk_header = 8;
  Container container;
  if (bytes.size() < header + chunk_header || word_at(bytes, 4) != 2) {
    throw Error({name}, "is not a binary glTF file of version 2", "export it as glTF 2.0");
  }
  bytes = bytes.substr(0, word_at(bytes, 8));
  for (size_t at = header; bytes.size() >= at + chunk_header;) {
    const size_t length = word_at(bytes, at);
    const std::uint32_t type = word_at(bytes, at + 4);
    at += chunk_header;
    if (length > bytes.size() - at) throw Error({name}, "the file is truncated", get_it_again);
    if (type == json_chunk && container.json.empty()) container.json = bytes.substr(at, length);
    if (type == binary_chunk && !container.binary) container.binary = bytes.substr(at, length);
    at += std::min((length + 3) / 4 * 4, bytes.size() - at);
  }
  if (container.json.empty()) throw Error({name}, "the file holds no JSON chunk", get_it_again);
  return container;
}

Place place_of_byte(std::string_view text, size_t byte, const std::string& name) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const size_t line_start = before.rfind('\n') + 1;
  return {name, static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(before.size() - line_start) + 1};
}

/// What this program reads of a glTF file; the rest never reaches the library, which trusts the
/// indices of meshes and materials and would load the images.
bool is_read(const std::string& section) {
  constexpr std::array sections = {"accessors", "animations", "asset", "bufferViews",
                                   "buffers",   "nodes",      "skins", "extensionsRequired"};
  return std::find(sections.begin(), sections.end(), section) != sections.end();
}

/// Takes out what is not read, below the sections: extras of any value, and extensions too.
void drop_unread(Json& value, bool keeps_extensions) {
  if (value.is_object()) {
    value.erase("extras");
    if (!keeps_extensions) value.erase("extensions");
  }
  if (!value.is_structured()) return;
  for (Json& inner : value) drop_unread(inner, keeps_extensions);
}

/// Buffers and their views may be compressed, as stated by an extension; animations may state
/// their frame rate in `extras`.
void drop_unread_sections(Json& json) {
  for (auto section = json.begin(); section != json.end();) {
    if (!is_read(section.key())) {
      section = json.erase(section);
      continue;
    }
    std::vector<std::pair<Json*, Json>> rates;
    if (section.key() == "animations" && section->is_array()) {
      for (Json& animation : *section) {
        const Json extras = animation.is_object() ? animation.value("extras", Json()) : Json();
        const Json rate = extras.is_object() ? extras.value(gltf_rate_key, Json()) : Json();
        if (rate.is_number()) rates.emplace_back(&animation, rate);
      }
    }
    drop_unread(*section, section.key() == "buffers" || section.key() == "bufferViews");
    for (auto& [animation, rate] : rates) (*animation)["extras"] = {{gltf_rate_key, rate}};
    ++section;
  }
}

/// The document of a file, without what is not read, and its humanoid.
struct Document {
  Json json;
  std::vector<HumanBone> bones;
};

Document parse_document(std::string_view text, const std::string& name) {
  // The library walks through values recursively.
  constexpr size_t deepest = 64;
  if (is_nested_deeper(text, deepest))
    throw Error({name}, "lists nested more than 64 deep", "this is not a glTF figure");
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object()) throw Error({name}, "is not a glTF file", get_it_again);
    const auto nodes = json.find("nodes");
    const size_t count = nodes == json.end() ? 0 : nodes->size();
    std::vector<HumanBone> bones = human_bones(json, count, name);
    drop_unread_sections(json);
    return {std::move(json), std::move(bones)};
  } catch (const Json::parse_error& error) {
    if (!text.starts_with('{') && without_compression(name).extension() != ".gltf")
      throw Error({name}, "is not a glTF file", get_it_again);
    throw Error(place_of_byte(text, error.byte, name), "this is not the JSON of a glTF file",
                get_it_again);
  } catch (const Json::out_of_range&) {
    throw Error({name}, "holds a number that is too large", get_it_again);
  }
}

void require_readable(const Json& json, const std::string& name) {
  const Json asset = json.value("asset", Json());
  const Json version = asset.is_object() ? asset.value("version", Json()) : Json();
  if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2.")) {
    throw Error({name}, "is not glTF of version 2", "export it as glTF 2.0");
  }
}

/// Each node takes the library half a kilobyte, and no figure has as many.
void require_few_nodes(const Json& json, const std::string& name) {
  constexpr size_t most_nodes = 131'072;
  const auto nodes = json.find("nodes");
  if (nodes == json.end() || nodes->size() <= most_nodes) return;
  throw Error({name}, "has more than " + std::to_string(most_nodes) + " nodes",
              "keep the nodes of one figure");
}

/// The buffers' bytes, taken out of the JSON.
std::vector<tinygltf::Buffer> parse_buffers(Json& json, std::optional<std::string_view> binary,
                                            const std::string& name,
                                            const std::optional<std::filesystem::path>& folder) {
  std::vector<tinygltf::Buffer> buffers;
  const Json list = json.value("buffers", Json::array());
  json.erase("buffers");
  for (const Json& entry : list) {
    const Json length = entry.is_object() ? entry.value("byteLength", Json()) : Json();
    if (!length.is_number_unsigned()) {
      throw Error({name}, "a buffer has no byteLength", get_it_again);
    }
    const Json uri = entry.value("uri", Json());
    tinygltf::Buffer buffer;
    if (uri.is_string()) {
      buffer.data = bytes_of_gltf_uri(uri.get<std::string>(), name, folder, "buffer");
    } else if (binary && buffers.empty()) {
      buffer.data.assign(binary->begin(), binary->end());
    } else if (is_meshopt_fallback(entry)) {
      buffers.push_back(std::move(buffer));
      continue;
    } else {
      throw Error({name}, "a buffer has no bytes", get_it_again);
    }
    if (buffer.data.size() < length.get<size_t>()) {
      throw Error({name}, "a buffer is shorter than its byteLength", get_it_again);
    }
    buffers.push_back(std::move(buffer));
  }
  return buffers;
}

}  // namespace

GltfFile parse_gltf_file(std::string_view bytes, const std::string& name,
                         const std::optional<std::filesystem::path>& folder) {
  const Container container = parse_container(bytes, name);
  auto [json, bones] = parse_document(container.json, name);
  require_readable(json, name);
  require_few_nodes(json, name);
  std::vector<tinygltf::Buffer> buffers = parse_buffers(json, container.binary, name, folder);
  unpack_meshopt(json, buffers, name);
  GltfFile file{name, {}, {}};
  std::string fault;
  std::string warning;
  bool understood = false;
  try {
    const std::string text = json.dump();
    understood = tinygltf::TinyGLTF().LoadASCIIFromString(
        &file.model, &fault, &warning, text.data(), static_cast<unsigned int>(text.size()), "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    fault = error.what();
  }
  if (!understood) {
    refuse(file,
           "is faulty: " + excerpt(fault.substr(0, fault.find('\n')), 2 * max_quoted_characters),
           get_it_again);
  }
  file.model.buffers = std::move(buffers);
  for (HumanBone& bone : bones) {
    if (bone.node >= static_cast<int>(file.model.nodes.size())) continue;
    file.model.nodes[static_cast<size_t>(bone.node)].name = std::move(bone.name);
    file.human_nodes.push_back(bone.node);
  }
  return file;
}

std::string_view gltf_json_text(std::string_view bytes, const std::string& name) {
  return parse_container(bytes, name).json;
}

std::string path_of_gltf_uri(const std::string& uri) {
  std::string path;
  for (size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uri[i + 1] & 0xFF) &&
                        std::isxdigit(uri[i + 2] & 0xFF);
    if (escape) {
      path += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

std::vector<unsigned char> bytes_of_gltf_uri(const std::string& uri, const std::string& name,
                                             const std::optional<std::filesystem::path>& folder,
                                             std::string_view use) {
  const std::string thing(use);
  // tinygltf does not know this kind; what decodes the picture looks at its bytes alone.
  constexpr std::string_view webp = "data:image/webp;";
  if (uri.starts_with(webp))
    return bytes_of_gltf_uri("data:image/png;" + uri.substr(webp.size()), name, folder, use);
  if (tinygltf::IsDataURI(uri)) {
    std::vector<unsigned char> bytes;
    std::string mime_type;
    if (!tinygltf::DecodeDataURI(&bytes, mime_type, uri, 0, false)) {
      throw Error({name}, "a " + thing + " inside the file cannot be decoded", get_it_again);
    }
    return bytes;
  }
  const std::filesystem::path path = path_of_gltf_uri(uri);
  if (!folder || path.is_absolute() || uri.find(':') != std::string::npos ||
      uri.find('\0') != std::string::npos) {
    throw Error({name}, "its " + thing + "s are not in the file",
                "export it as .glb, all in one file");
  }
  if (const std::string problem = read_error(*folder / path, max_recording_bytes);
      !problem.empty()) {
    throw Error({name}, "its " + thing + " " + in_quotes(path.string()) + " " + problem,
                "put it beside the file, or export it as .glb, all in one file");
  }
  const std::string contents = read_contents(*folder / path);
  return {contents.begin(), contents.end()};
}

void refuse(const GltfFile& file, std::string_view wrong, std::string_view remedy) {
  throw Error({file.name}, wrong, remedy);
}

}  // namespace mien::motion
