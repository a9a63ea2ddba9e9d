#include "pipeline/production/film/disk_light_cache.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/hash.h"
#include "pipeline/tasks/stale_artifacts.h"
#include "pipeline/tasks/task_graph.h"
#include "render/error.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr const char* light_folder = ".mien/light";
constexpr auto pause_between_looks = std::chrono::milliseconds(200);

// Width and height as 32 bits each, then the channels as floats, all as the machine has them: what
// was written by another kind of machine has another key.
constexpr std::size_t head_bytes = 2 * sizeof(std::int32_t);

std::string bytes_of(const render::Framebuffer& light) {
  const std::array<std::int32_t, 2> size{light.width, light.height};
  const std::size_t channels = light.channels.size() * sizeof(float);
  std::string bytes(head_bytes + channels, '\0');
  std::memcpy(bytes.data(), size.data(), head_bytes);
  std::memcpy(bytes.data() + head_bytes, light.channels.data(), channels);
  return bytes;
}

std::optional<render::Framebuffer> light_of(std::string_view bytes) {
  std::array<std::int32_t, 2> size{};
  if (bytes.size() < head_bytes) return std::nullopt;
  std::memcpy(size.data(), bytes.data(), head_bytes);
  const auto [width, height] = size;
  const std::size_t values = (bytes.size() - head_bytes) / sizeof(float);
  if (width < 1 || height < 1 ||
      values != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return std::nullopt;
  render::Framebuffer light(width, height);
  std::memcpy(light.channels.data(), bytes.data() + head_bytes, values * sizeof(float));
  return light;
}

Hash key_of_light(const std::string& name) {
  KeyBuilder key;
  key.add("set", name).add("code", film_code());
  key.add("order of bytes", std::int64_t{std::endian::native == std::endian::little});
  for (const auto& [library, version] : library_versions()) key.add(library, version);
  return key.key();
}

/// Removes the light that was used longest ago until no more than `most` bytes are left.
void evict_beyond(const Store& store, std::uintmax_t most) {
  struct CachedFile {
    fs::file_time_type used;
    std::uintmax_t bytes;
    fs::path file;
  };
  std::vector<CachedFile> all;
  std::uintmax_t bytes = 0;
  std::error_code gone;  // another process may be faster
  for (const fs::path& file : paths_in(store.folder() / light_folder)) {
    const CachedFile kept{fs::last_write_time(file, gone), fs::file_size(file, gone), file};
    if (gone) continue;
    bytes += kept.bytes;
    all.push_back(kept);
  }
  std::ranges::sort(all, {}, &CachedFile::used);
  for (auto oldest = all.begin(); oldest != all.end() && bytes > most; ++oldest) {
    const std::string path = oldest->file.lexically_relative(store.folder()).generic_string();
    const auto receipt = read_receipt(store.folder(), path);
    if (receipt) remove_artifact(store, *receipt);
    fs::remove(oldest->file, gone);
    bytes -= oldest->bytes;
  }
}

class DiskLightCache {
 public:
  DiskLightCache(Store& store, std::stop_token stop, std::uintmax_t most_bytes)
      : store_(&store), stop_(std::move(stop)), most_bytes_(most_bytes) {}

  render::Framebuffer operator()(const std::string& name,
                                 const std::function<render::Framebuffer()>& draw) const {
    const std::string path = std::string(light_folder) + "/" + name;
    const Hash key = key_of_light(name);
    for (;;) {
      if (auto light = found(path, key)) return *std::move(light);
      if (const auto claim = store_->claim("light " + name)) {
        if (auto light = found(path, key)) return *std::move(light);
        return drawn(path, key, draw);
      }
      if (stop_.stop_requested()) throw Interrupted{};
      std::this_thread::sleep_for(pause_between_looks);
    }
  }

 private:
  std::optional<render::Framebuffer> found(const std::string& path, const Hash& key) const {
    if (!store_->find(path, key)) return std::nullopt;
    const fs::path file = store_->folder() / path;
    try {
      auto light = light_of(read_file(file));
      std::error_code ignored;
      fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
      return light;
    } catch (const std::exception&) {
      return std::nullopt;  // removed in this moment, to keep within bounds
    }
  }

  render::Framebuffer drawn(const std::string& path, const Hash& key,
                            const std::function<render::Framebuffer()>& draw) const {
    const render::Framebuffer light = draw();
    store_->put(
        path, key, [&](const fs::path& file) { write_file(file, bytes_of(light)); },
        [&](const fs::path& file) {
          if (light_of(read_file(file)) != light)
            throw render::Error(file.string() + ": differs from what was written");
        });
    evict_beyond(*store_, most_bytes_);
    return light;
  }

  Store* store_;
  std::stop_token stop_;
  std::uintmax_t most_bytes_;
};

}  // namespace

render::LightCache disk_light_cache(Store& store, const std::stop_token& stop,
                                    std::uintmax_t most_bytes) {
  return DiskLightCache(store, stop, most_bytes);
}

}  // namespace mien::pipeline
