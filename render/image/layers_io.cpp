#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "render/error.h"
#include "render/image/image_io.h"
#include "render/image_files/image_files.h"

namespace mien::render {
namespace {

/// One part of the file.
struct FilePart {
  ImagePart part;
  std::vector<float> own;  // its values, if nothing else holds them
};

ImagePart part_of(const Layers& layers, const std::string& name,
                  std::vector<std::string> channels) {
  return {.width = layers.albedo.width,
          .height = layers.albedo.height,
          .count = static_cast<int>(channels.size()),
          .channels = std::move(channels),
          .stored = ChannelKind::single,
          // Without a date, OpenImageIO writes the time at which the file is made.
          .attributes = {{"oiio:subimagename", name},
                         {"name", name},
                         {"compression", "zip"},
                         {"oiio:ColorSpace", "Linear"},
                         {"DateTime", ""}},
          .given = ChannelKind::single};
}

std::string hex(std::uint32_t value) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) text += digits[(value >> shift) & 15u];
  return text;
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string manifest_of(const CoverageLayer& layer) {
  std::string text;
  for (const std::string& name : layer.names)
    text += (text.empty() ? "{" : ",") + quoted(name) + ":\"" + hex(layer_id(name)) + "\"";
  return text.empty() ? "{}" : text + "}";
}

FilePart cryptomatte(const Layers& layers, const std::string& name, const CoverageLayer& layer) {
  std::vector<std::string> channels;
  for (const char* level : {"00", "01", "02"})
    for (const char* channel : {".R", ".G", ".B", ".A"}) channels.push_back(name + level + channel);
  FilePart part;
  part.part = part_of(layers, name, std::move(channels));
  const std::string key = "cryptomatte/" + hex(layer_id(name)).substr(0, 7) + "/";
  part.part.attributes.emplace_back(key + "name", name);
  part.part.attributes.emplace_back(key + "hash", "MurmurHash3_32");
  part.part.attributes.emplace_back(key + "conversion", "uint32_to_float32");
  part.part.attributes.emplace_back(key + "manifest", manifest_of(layer));
  part.own.reserve(2 * layer.ranks.size());
  for (const Coverage& coverage : layer.ranks) {
    part.own.push_back(std::bit_cast<float>(coverage.id));
    part.own.push_back(coverage.share);
  }
  return part;
}

std::vector<FilePart> parts_of(const Layers& layers) {
  std::vector<FilePart> parts;
  const auto add = [&](const char* name, std::vector<std::string> channels,
                       const std::vector<float>& values) {
    parts.push_back({part_of(layers, name, std::move(channels)), {}});
    parts.back().part.values = values.data();
  };
  add("beauty", {"R", "G", "B"}, layers.beauty.channels);
  add("albedo", {"albedo.R", "albedo.G", "albedo.B"}, layers.albedo.channels);
  add("normal", {"normal.X", "normal.Y", "normal.Z"}, layers.normal.channels);
  add("position", {"position.X", "position.Y", "position.Z"}, layers.position.channels);
  add("depth", {"depth.Z"}, layers.depth);
  add("motion", {"motion.X", "motion.Y"}, layers.motion);
  add("samples", {"samples.Y"}, layers.samples);
  add("variance", {"variance.Y"}, layers.variance);
  parts.push_back(cryptomatte(layers, "crypto_figure", layers.figures));
  parts.push_back(cryptomatte(layers, "crypto_part", layers.parts));
  for (FilePart& part : parts)
    if (!part.own.empty()) part.part.values = part.own.data();
  return parts;
}

}  // namespace

void write_layers(const std::filesystem::path& path, const Layers& layers) {
  const std::vector<FilePart> parts = parts_of(layers);
  std::vector<ImagePart> written;
  for (const FilePart& part : parts) written.push_back(part.part);
  std::string error;
  if (!image_files().write(path.string(), written, error))
    throw Error(path.string() + ": cannot be written: " + error);
}

}  // namespace mien::render
