#include <bit>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "render/error.h"
#include "render/image/image_io.h"

namespace mien::render {
namespace {

using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

/// One part of the file.
struct FilePart {
  ImageSpec spec;
  const float* values = nullptr;
  std::vector<float> own;  // what `values` points to, if nothing else holds it
};

ImageSpec spec_of(const Layers& layers, const std::string& name,
                  std::vector<std::string> channels) {
  ImageSpec spec(layers.albedo.width, layers.albedo.height, static_cast<int>(channels.size()),
                 TypeDesc::FLOAT);
  spec.channelnames = std::move(channels);
  spec.attribute("oiio:subimagename", name);
  spec.attribute("name", name);
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("DateTime", "");  // else OpenImageIO writes the time at which it is made
  return spec;
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
  part.spec = spec_of(layers, name, std::move(channels));
  const std::string key = "cryptomatte/" + hex(layer_id(name)).substr(0, 7) + "/";
  part.spec.attribute(key + "name", name);
  part.spec.attribute(key + "hash", "MurmurHash3_32");
  part.spec.attribute(key + "conversion", "uint32_to_float32");
  part.spec.attribute(key + "manifest", manifest_of(layer));
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
    parts.push_back({spec_of(layers, name, std::move(channels)), values.data(), {}});
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
    if (!part.own.empty()) part.values = part.own.data();
  return parts;
}

}  // namespace

void write_layers(const std::filesystem::path& path, const Layers& layers) {
  const auto fail = [&](const std::string& why) {
    throw Error(path.string() + ": cannot be written: " + why);
  };
  const std::vector<FilePart> parts = parts_of(layers);
  std::vector<ImageSpec> specs;
  for (const FilePart& part : parts) specs.push_back(part.spec);
  const auto output = ImageOutput::create(path.string());
  if (!output) fail(OIIO::geterror());
  if (!output->open(path.string(), static_cast<int>(specs.size()), specs.data()))
    fail(output->geterror());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0 && !output->open(path.string(), specs[i], ImageOutput::AppendSubimage))
      fail(output->geterror());
    if (!output->write_image(TypeDesc::FLOAT, parts[i].values)) fail(output->geterror());
  }
  if (!output->close()) fail(output->geterror());
}

}  // namespace mien::render
