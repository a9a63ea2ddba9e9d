#include "render/image/layers.h"

#include <cstring>

namespace mien::render {
namespace {

std::uint32_t rotated(std::uint32_t x, int bits) { return (x << bits) | (x >> (32 - bits)); }

std::uint32_t scrambled(std::uint32_t block) {
  return rotated(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

std::uint32_t murmur3(const std::string& text) {
  std::uint32_t hash = 0;
  const std::size_t blocks = text.size() / 4;
  for (std::size_t i = 0; i < blocks; ++i) {
    std::uint32_t block;
    std::memcpy(&block, text.data() + 4 * i, 4);
    hash = rotated(hash ^ scrambled(block), 13) * 5u + 0xe6546b64u;
  }
  std::uint32_t tail = 0;
  for (std::size_t i = text.size(); i > 4 * blocks; --i)
    tail = (tail << 8) | static_cast<unsigned char>(text[i - 1]);
  if (text.size() % 4 != 0) hash ^= scrambled(tail);
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  return hash ^ (hash >> 16);
}

}  // namespace

std::uint32_t layer_id(const std::string& name) {
  const std::uint32_t hash = murmur3(name);
  const std::uint32_t exponent = (hash >> 23) & 255u;
  return exponent == 0u || exponent == 255u ? hash ^ (1u << 23) : hash;
}

Layers crop(Layers layers, const Window& window) {
  const int width = layers.albedo.width;
  for (Framebuffer* framebuffer : {&layers.albedo, &layers.normal, &layers.position})
    *framebuffer = crop(*framebuffer, window);
  for (std::vector<float>* values : {&layers.depth, &layers.samples, &layers.variance})
    *values = crop(*values, width, window);
  layers.motion = crop(layers.motion, width, window, 2);
  for (CoverageLayer* layer : {&layers.figures, &layers.parts})
    layer->ranks = crop(layer->ranks, width, window, covered_ranks);
  return layers;
}

}  // namespace mien::render
