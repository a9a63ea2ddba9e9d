#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "motion/error.h"
#include "motion/formats/gltf/gltf_accessor.h"
#include "render/error.h"
#include "render/scene/texture_io.h"
#include "scenes/character/character_file.h"

namespace mien::scenes {

namespace {

using nlohmann::json;

using motion::get_it_again;

/// What stands under `key` when it is an object, else an empty object.
const json& object_in(const json& object, const char* key) {
  static const json none = json::object();
  if (!object.is_object()) return none;
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? *found : none;
}

render::Texture decoded(const CharacterFile& file, std::span<const unsigned char> bytes,
                        render::TextureUse kind, const std::string& use) {
  try {
    return render::read_texture(bytes, use, kind);
  } catch (const render::Error& error) {
    throw Error({file.gltf.name}, std::string("a picture cannot be decoded: ") + error.what(),
                "export its pictures as PNG, JPEG or WebP");
  }
}

render::Texture picture(const CharacterFile& file, int image, render::TextureUse kind) {
  const json& given = list_in(file.json, "images")[static_cast<size_t>(image)];
  const std::string use = "image " + std::to_string(image);
  const int view = index_in(file, given, "bufferView", file.gltf.model.bufferViews.size(), use);
  if (view >= 0) return decoded(file, motion::buffer_view_bytes(file.gltf, view, use), kind, use);
  const auto uri = given.is_object() ? given.find("uri") : given.end();
  if (!given.is_object() || uri == given.end() || !uri->is_string()) {
    motion::refuse(file.gltf, use + " has no bytes", get_it_again);
  }
  return decoded(
      file,
      motion::bytes_of_gltf_uri(uri->get<std::string>(), file.gltf.name, file.folder, "picture"),
      kind, use);
}

/// Reads each picture once for each use.
struct Painter {
  const CharacterFile& file;
  CharacterMaterials paint;
  std::map<std::pair<int, render::TextureUse>, int> texture_of_image;
  bool has_unread = false;  ///< a texture of an extension's kind

  /// The picture of a texture, or its WebP twin where that is the only one; −1 when it has neither.
  int image_of(const json& texture, const std::string& use) const {
    const size_t count = list_in(file.json, "images").size();
    const int image = index_in(file, texture, "source", count, use);
    if (image >= 0) return image;
    const json& webp = object_in(object_in(texture, "extensions"), "EXT_texture_webp");
    return index_in(file, webp, "source", count, use);
  }

  /// Index of the texture that a material's entry names; −1 when it has none that can be drawn.
  int texture(const json& entry, render::TextureUse kind, const std::string& use) {
    const json& textures = list_in(file.json, "textures");
    const int index = index_in(file, entry, "index", textures.size(), use);
    if (index < 0) return -1;
    const int image = image_of(textures[static_cast<size_t>(index)], use);
    has_unread |= image < 0;
    if (image < 0) return -1;
    const auto [known, is_new] =
        texture_of_image.try_emplace({image, kind}, static_cast<int>(paint.textures.size()));
    if (is_new) paint.textures.push_back(picture(file, image, kind));
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

float scale_of(const CharacterFile& file, const json& bumps, const std::string& use) {
  const auto scale = bumps.find("scale");
  if (scale == bumps.end()) return 1.0f;
  if (!scale->is_number() || !(std::abs(scale->get<double>()) <= 100.0)) {
    motion::refuse(file.gltf, use + ": it has no valid normal scale", get_it_again);
  }
  return scale->get<float>();
}

bool has_own_coordinates(const json& texture) {
  return texture.value("texCoord", json(0)) != 0 ||
         object_in(texture, "extensions").contains("KHR_texture_transform");
}

bool is_see_through(const json& given) {
  const auto mode = given.find("alphaMode");
  return mode != given.end() && (*mode == "BLEND" || *mode == "MASK");
}

}  // namespace

CharacterMaterials gltf_materials(const CharacterFile& file, std::vector<std::string>& warnings) {
  Painter painter{file, {}, {}, false};
  painter.paint.materials.push_back(plain_material());
  bool has_see_through = false;
  bool has_other_coordinates = false;
  const json& materials = list_in(file.json, "materials");
  for (size_t m = 0; m < materials.size(); ++m) {
    const std::string use = "material " + std::to_string(m);
    if (!materials[m].is_object()) motion::refuse(file.gltf, use + " is none", get_it_again);
    const json& surface = object_in(materials[m], "pbrMetallicRoughness");
    const json& base = object_in(surface, "baseColorTexture");
    render::Material material{factor_of(file, surface, use), 0.03f, 0.6f};
    const json& bumps = object_in(materials[m], "normalTexture");
    material.texture = painter.texture(base, render::TextureUse::colour, use);
    material.normal_map = painter.texture(bumps, render::TextureUse::numbers, use);
    material.normal_scale = scale_of(file, bumps, use);
    painter.paint.materials.push_back(material);
    has_see_through |= is_see_through(materials[m]);
    has_other_coordinates |= has_own_coordinates(base) || has_own_coordinates(bumps);
  }
  if (painter.has_unread) {
    warnings.push_back("Some textures are neither PNG, JPEG nor WebP; their surfaces are plain.");
  }
  if (has_see_through) warnings.push_back("Transparent materials are drawn opaque.");
  if (has_other_coordinates) {
    warnings.push_back("Texture transforms and second texture coordinates are not applied.");
  }
  return std::move(painter.paint);
}

}  // namespace mien::scenes
