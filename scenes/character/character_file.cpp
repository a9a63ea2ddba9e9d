#include "scenes/character/character_file.h"

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::scenes {

using nlohmann::json;

CharacterFile parse_character_file(std::string_view bytes, const std::string& name,
                                   const std::optional<std::filesystem::path>& folder) {
  CharacterFile file{motion::parse_gltf_file(bytes, name, folder), {}, {}, folder};
  const std::string_view text = motion::gltf_json_text(bytes, name);
  file.json = json::parse(text.begin(), text.end());  // has been parsed before
  for (const json& extension : list_in(file.json, "extensionsRequired")) {
    if (extension == "KHR_draco_mesh_compression") {
      motion::refuse(file.gltf, "its meshes are compressed by Draco", "export it uncompressed");
    }
  }
  file.nodes = motion::parse_nodes(file.gltf);
  return file;
}

const json& list_in(const json& object, const char* key) {
  static const json none = json::array();
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : none;
}

int index_in(const CharacterFile& file, const json& object, const char* key, size_t count,
             const std::string& use) {
  if (!object.is_object()) return -1;
  const auto found = object.find(key);
  if (found == object.end()) return -1;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() >= count) {
    motion::refuse(file.gltf,
                   use + ": there is no " + key + " " +
                       motion::excerpt(found->dump(-1, ' ', false, json::error_handler_t::replace)),
                   "export or download the file again");
  }
  return found->get<int>();
}

}  // namespace mien::scenes
