#include <algorithm>
#include <map>

#include "motion/error.h"
#include "motion/gltf_accessor.h"
#include "render/error.h"
#include "render/texture_io.h"
#include "scenes/character_file.h"

namespace mien::scenes {

namespace {

using nlohmann::json;

constexpr std::string_view get_it_again = "export or download the file again";

/// What stands under `key` when it is an object, else an empty object.
const json& object_in(const json& object, const char* key) {
  static const json none = json::object();
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? *found : none;
}

render::Texture decoded(const CharacterFile& file, std::span<const unsigned char> bytes,
                        const std::string& use) {
  try {
    return render::read_texture(bytes, use);
  } catch (const render::Error& error) {
    throw Error({file.gltf.name}, std::string("a picture does not decode: ") + error.what(),
                "export its pictures as PNG or JPEG");
  }
}

render::Texture picture(const CharacterFile& file, int image) {
  const json& given = list_in(file.json, "images")[static_cast<size_t>(image)];
  const std::string use = "image " + std::to_string(image);
  const int view = index_in(file, given, "bufferView", file.gltf.model.bufferViews.size(), use);
  if (view >= 0) return decoded(file, motion::buffer_view_bytes(file.gltf, view, use), use);
  const auto uri = given.is_object() ? given.find("uri") : given.end();
  if (!given.is_object() || uri == given.end() || !uri->is_string()) {
    motion::refuse(file.gltf, use + " has no bytes", get_it_again);
  }
  return decoded(
      file,
      motion::bytes_of_gltf_uri(uri->get<std::string>(), file.gltf.name, file.folder, "picture"),
      use);
}

/// Reads each picture once.
struct Painter {
  const CharacterFile& file;
  CharacterPaint paint;
  std::map<int, int> texture_of_image;

  /// Index of the texture that a material's entry names; −1 when it has none that can be drawn.
  int texture(const json& entry, const std::string& use) {
    const json& textures = list_in(file.json, "textures");
    const int index = index_in(file, entry, "index", textures.size(), use);
    if (index < 0) return -1;
    const int image = index_in(file, textures[static_cast<size_t>(index)], "source",
                               list_in(file.json, "images").size(), use);
    if (image < 0) return -1;
    const auto [known, is_new] =
        texture_of_image.try_emplace(image, static_cast<int>(paint.textures.size()));
    if (is_new) paint.textures.push_back(picture(file, image));
    return known->second;
  }
};

render::Color factor_of(const CharacterFile& file, const json& given, const std::string& use) {
  const json& numbers = list_in(given, "baseColorFactor");
  render::Color factor = render::Color::Ones();
  if (numbers.empty()) return factor;
  for (size_t c = 0; c < 3; ++c) {
    const bool is_share = numbers.size() == 4 && numbers[c].is_number() &&
                          numbers[c].get<double>() >= 0.0 && numbers[c].get<double>() <= 1.0;
    if (!is_share) motion::refuse(file.gltf, use + ": no colour", get_it_again);
    factor[static_cast<int>(c)] = numbers[c].get<float>();
  }
  return factor;
}

bool is_see_through(const json& given) {
  const auto mode = given.find("alphaMode");
  return mode != given.end() && (*mode == "BLEND" || *mode == "MASK");
}

}  // namespace

CharacterPaint character_paint(const CharacterFile& file, std::vector<std::string>& warnings) {
  Painter painter{file, {}, {}};
  painter.paint.materials.push_back({render::Color(0.6f, 0.6f, 0.6f), 0.03f, 0.5f});
  bool has_normal_maps = false;
  bool has_see_through = false;
  bool has_other_coordinates = false;
  const json& materials = list_in(file.json, "materials");
  for (size_t m = 0; m < materials.size(); ++m) {
    const std::string use = "material " + std::to_string(m);
    if (!materials[m].is_object()) motion::refuse(file.gltf, use + " is none", get_it_again);
    const json& surface = object_in(materials[m], "pbrMetallicRoughness");
    const json& base = object_in(surface, "baseColorTexture");
    render::Material material{factor_of(file, surface, use), 0.03f, 0.6f};
    material.texture = painter.texture(base, use);
    painter.paint.materials.push_back(material);
    has_normal_maps |= materials[m].contains("normalTexture");
    has_see_through |= is_see_through(materials[m]);
    has_other_coordinates |= base.value("texCoord", json(0)) != 0 ||
                             object_in(base, "extensions").contains("KHR_texture_transform");
  }
  if (has_normal_maps) warnings.push_back("Normal maps are not drawn.");
  if (has_see_through) warnings.push_back("Transparent materials are drawn opaque.");
  if (has_other_coordinates) {
    warnings.push_back("Texture transforms and second texture coordinates are not applied.");
  }
  return std::move(painter.paint);
}

}  // namespace mien::scenes
