#include "motion/formats/fbx/fbx_material.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "motion/formats/fbx/fbx_values.h"

namespace mien::motion {

namespace {

const FbxObject& object_at(const FbxScene& scene, int object) {
  return scene.objects.objects[static_cast<size_t>(object)];
}

/// The texture of an object, or the lowest one of a stack of them; −1 for another object.
int texture_of(const FbxScene& scene, int object) {
  if (object_at(scene, object).kind == "Texture") return object;
  if (object_at(scene, object).kind != "LayeredTexture") return -1;
  for (const int c : scene.objects.to[static_cast<size_t>(object)]) {
    const int child = scene.objects.connections[static_cast<size_t>(c)].child;
    if (object_at(scene, child).kind == "Texture") return child;
  }
  return -1;
}

double share_of(double number) { return std::clamp(number, 0.0, 1.0); }

/// Bytes of base64; empty if it is not valid.
std::string from_base64(std::string_view text) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<int, 256> digits{};
  digits.fill(-1);
  for (size_t i = 0; i < letters.size(); ++i) {
    digits[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
  }
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '=' || letter == '\r' || letter == '\n') continue;
    const int digit = digits[static_cast<unsigned char>(letter)];
    if (digit < 0) return "";
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

/// The name of the set of texture coordinates, which is a text among the properties.
std::string uv_set_of(const FbxDocument& document, std::uint32_t texture) {
  const std::uint32_t list = find_child(document, texture, "Properties70");
  if (list == 0) return "";
  for (std::uint32_t node = first_child(list); node < document.nodes[list].end;
       node = document.nodes[node].end) {
    if (text_of(document, node, 0) == "UVSet") return decoded(document, text_of(document, node, 4));
  }
  return "";
}

void add_file_names(const FbxScene& scene, int object, std::vector<std::string>& files) {
  for (const std::string_view name : {"RelativeFilename", "FileName", "Filename"}) {
    const std::uint32_t node = find_child(scene.document, object_at(scene, object).node, name);
    if (node == 0) continue;
    std::string path = decoded(scene.document, text_of(scene.document, node, 0));
    if (!path.empty()) files.push_back(std::move(path));
  }
}

}  // namespace

FbxMaterial fbx_material(const FbxScene& scene, int object) {
  FbxMaterial material;
  material.name = object_at(scene, object).name;
  for (const FbxProperty& property : properties_of(scene.document, object_at(scene, object).node)) {
    if (property.count == 3 && property.name == "DiffuseColor") {
      for (int c = 0; c < 3; ++c) {
        material.colour[c] = share_of(property.numbers[static_cast<size_t>(c)]);
      }
    }
    if (property.count == 0) continue;
    if (property.name == "DiffuseFactor") material.factor = share_of(property.numbers[0]);
    if (property.name == "Opacity") material.is_transparent |= property.numbers[0] < 1.0;
  }
  for (const int c : scene.objects.to[static_cast<size_t>(object)]) {
    const FbxConnection& connection = scene.objects.connections[static_cast<size_t>(c)];
    const int texture = texture_of(scene, connection.child);
    if (texture < 0) continue;
    const bool is_colour = connection.property == "DiffuseColor";
    if (is_colour && material.colour_texture < 0) material.colour_texture = texture;
    if (connection.property == "NormalMap") material.normal_texture = texture;
    material.is_transparent |=
        connection.property == "TransparentColor" || connection.property == "TransparencyFactor";
  }
  return material;
}

FbxTexture fbx_texture(const FbxScene& scene, int object) {
  FbxTexture texture;
  add_file_names(scene, object, texture.files);
  for (const FbxProperty& property : properties_of(scene.document, object_at(scene, object).node)) {
    const bool is_moved = (property.name == "Translation" || property.name == "Rotation") &&
                          property.numbers != std::array{0.0, 0.0, 0.0};
    const bool is_scaled =
        property.name == "Scaling" && (property.numbers[0] != 1.0 || property.numbers[1] != 1.0);
    texture.is_transformed |= property.count == 3 && (is_moved || is_scaled);
  }
  texture.uv_set = uv_set_of(scene.document, object_at(scene, object).node);
  for (const int c : scene.objects.to[static_cast<size_t>(object)]) {
    const int video = scene.objects.connections[static_cast<size_t>(c)].child;
    if (object_at(scene, video).kind != "Video") continue;
    add_file_names(scene, video, texture.files);
    if (texture.video < 0) texture.video = video;
  }
  return texture;
}

std::string fbx_picture(const FbxScene& scene, int video) {
  const FbxDocument& document = scene.document;
  const std::uint32_t node = find_child(document, object_at(scene, video).node, "Content");
  if (node == 0) return "";
  const FbxValue::Kind kind = document.is_text ? FbxValue::Kind::text : FbxValue::Kind::raw;
  FbxValueCursor cursor = values_of(document, node);
  std::string contents;
  while (const std::optional<FbxValue> value = next_value(cursor)) {
    if (value->kind == kind) contents += value->text;
  }
  return document.is_text ? from_base64(contents) : contents;
}

}  // namespace mien::motion
