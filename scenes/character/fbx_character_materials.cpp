#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_material.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/safe_name.h"
#include "render/error.h"
#include "render/scene/texture_io.h"
#include "scenes/character/fbx_character.h"

namespace mien::scenes {

namespace {

namespace fs = std::filesystem;

using motion::FbxMaterial;
using motion::FbxScene;
using motion::FbxTexture;

/// Paths of Windows have backslashes.
std::string with_slashes(std::string path) {
  std::ranges::replace(path, '\\', '/');
  return path;
}

/// Where the picture of a texture may be, as paths that do not lead out of the file's folder.
std::vector<std::string> places_of_picture(const FbxTexture& texture, const std::string& fbx) {
  std::vector<std::string> places;
  const auto add = [&](const std::string& path) {
    if (motion::fault_of_names(path).empty()) places.push_back(path);
  };
  const std::string own_folder = fs::path(fbx).stem().string() + ".fbm/";
  for (const std::string& given : texture.files) {
    std::string path = with_slashes(given);
    while (path.starts_with("./")) path.erase(0, 2);
    const std::string last = path.substr(path.rfind('/') + 1);
    add(path);
    add(last);
    add(own_folder + last);
  }
  return places;
}

/// The file of a texture's picture, the first that exists.
std::optional<fs::path> picture_file(const FbxTexture& texture, const std::string& fbx,
                                     const fs::path& folder) {
  for (const std::string& place : places_of_picture(texture, fbx)) {
    const fs::path path = folder / place;
    if (motion::is_inside(folder, place) &&
        motion::read_error(path, motion::max_recording_bytes).empty())
      return path;
  }
  return std::nullopt;
}

/// Reads each picture once for each use.
struct FbxPainter {
  const FbxScene& scene;
  const std::optional<fs::path>& folder;
  std::vector<std::string>& warnings;
  FbxPaint made{};
  /// By the object that holds the picture, or else its texture; −1: cannot be drawn.
  std::map<std::pair<int, render::TextureUse>, int> texture_of{};
  std::set<std::string> missing{};
  bool has_transform = false;

  std::string bytes_of(const FbxTexture& texture) const {
    const std::string own = texture.video < 0 ? "" : motion::fbx_picture(scene, texture.video);
    if (!own.empty() || !folder) return own;
    const auto file = picture_file(texture, scene.document.file, *folder);
    return file ? motion::read_contents(*file) : "";
  }

  int unreadable(const FbxTexture& texture, const std::string& why) {
    std::string name = texture.files.empty() ? "" : with_slashes(texture.files.front());
    name = name.substr(name.rfind('/') + 1);
    if (missing.insert(name).second)
      warnings.push_back("The picture " + motion::in_quotes(name) + " " + why +
                         ", so its surfaces have a plain colour.");
    return -1;
  }

  int read(const FbxTexture& texture, render::TextureUse use) {
    const std::string bytes = bytes_of(texture);
    if (bytes.empty()) return unreadable(texture, "is not in the file or beside it");
    const std::span<const unsigned char> view(reinterpret_cast<const unsigned char*>(bytes.data()),
                                              bytes.size());
    try {
      made.paint.textures.push_back(render::read_texture(view, "picture", use));
    } catch (const render::Error&) {
      return unreadable(texture, "is not PNG, JPEG or WebP");
    }
    return static_cast<int>(made.paint.textures.size()) - 1;
  }

  int texture(int object, render::TextureUse use) {
    if (object < 0) return -1;
    const FbxTexture texture = motion::fbx_texture(scene, object);
    const int holder = texture.video >= 0 ? texture.video : object;
    auto known = texture_of.find({holder, use});
    if (known == texture_of.end())
      known = texture_of.emplace(std::pair(holder, use), read(texture, use)).first;
    has_transform |= texture.is_transformed && known->second >= 0;
    return known->second;
  }

  void add(int object) {
    if (made.material_of.contains(object)) return;
    const FbxMaterial given = motion::fbx_material(scene, object);
    render::Material material{render::Color::Ones(), 0.03f, 0.6f};
    material.texture = texture(given.colour_texture, render::TextureUse::colour);
    material.normal_map = texture(given.normal_texture, render::TextureUse::numbers);
    if (material.texture < 0) material.albedo = given.colour.cast<float>().array();
    material.albedo *= static_cast<float>(given.factor);
    const int placed = given.colour_texture >= 0 ? given.colour_texture : given.normal_texture;
    if (placed >= 0) made.uv_set_of[object] = motion::fbx_texture(scene, placed).uv_set;
    made.material_of[object] = static_cast<int>(made.paint.materials.size());
    made.paint.materials.push_back(material);
    has_transparent |= given.is_transparent;
  }

  bool has_transparent = false;
};

}  // namespace

FbxPaint fbx_paint(const FbxCharacter& character, const std::optional<fs::path>& folder,
                   std::vector<std::string>& warnings) {
  FbxPainter painter{character.scene, folder, warnings};
  painter.made.paint.materials.push_back(plain_material());
  for (const PlacedMesh& placed : character.rig.meshes) {
    for (const int object : character.meshes[static_cast<size_t>(placed.mesh)].materials)
      painter.add(object);
  }
  if (painter.has_transparent) warnings.push_back("Transparent materials are drawn opaque.");
  if (painter.has_transform) warnings.push_back("Texture transforms are not applied.");
  return std::move(painter.made);
}

std::vector<fs::path> files_of_fbx(std::string_view bytes, const std::string& name,
                                   const fs::path& folder) {
  const FbxScene scene = motion::parse_fbx_scene(bytes, name);
  std::vector<fs::path> files;
  for (size_t o = 0; o < scene.objects.objects.size(); ++o) {
    if (scene.objects.objects[o].kind != "Material") continue;
    const FbxMaterial material = motion::fbx_material(scene, static_cast<int>(o));
    for (const int object : {material.colour_texture, material.normal_texture}) {
      if (object < 0) continue;
      const FbxTexture texture = motion::fbx_texture(scene, object);
      if (texture.video >= 0 && !motion::fbx_picture(scene, texture.video).empty()) continue;
      const auto file = picture_file(texture, name, folder);
      if (file && std::ranges::find(files, *file) == files.end()) files.push_back(*file);
    }
  }
  return files;
}

}  // namespace mien::scenes
