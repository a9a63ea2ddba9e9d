#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "render/light/static_background.h"

namespace mien::render {

/// Static backgrounds shared by concurrent tracers: each is rendered by the first tracer that needs
/// it and shared as long as any of them uses it. The cache must outlive the tracers.
class StaticBackgroundCache {
 public:
  /// Shared ownership, because no tracer knows whether it is the last user.
  using Handle = std::shared_ptr<const StaticBackground>;

  /// Returns the background with this name (static_background_name), made by `make` unless it
  /// exists. Waits while another thread makes it, and makes it if that thread fails. Throws what
  /// `make` throws.
  Handle get_or_make(const std::string& name, const std::function<StaticBackground()>& make);

 private:
  struct Entry {
    std::weak_ptr<const StaticBackground> background;
    bool in_progress = false;
  };

  void erase_expired();

  std::mutex mutex_;
  std::condition_variable ended_;  // notified when a background is finished
  std::map<std::string, Entry> entries_;
};

/// Looks up the rendered radiance of a background with static solids by its name, or calls `draw`
/// and stores the result. The result is that of `draw`, bit for bit.
using LightCache =
    std::function<Framebuffer(const std::string& name, const std::function<Framebuffer()>& draw)>;

}  // namespace mien::render
