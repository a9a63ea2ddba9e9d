#include "render/tracer/static_background_cache.h"

namespace mien::render {

StaticBackgroundCache::Handle StaticBackgroundCache::get_or_make(
    const std::string& name, const std::function<StaticBackground()>& make) {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [&] {
    const auto entry = entries_.find(name);
    return entry == entries_.end() || !entry->second.in_progress;
  });
  if (Handle there = entries_[name].background.lock()) return there;
  entries_[name].in_progress = true;
  lock.unlock();
  Handle made;
  try {
    made = std::make_shared<const StaticBackground>(make());
  } catch (...) {
    lock.lock();
    entries_.erase(name);
    ended_.notify_all();
    throw;
  }
  lock.lock();
  erase_expired();
  entries_[name] = {made, false};
  ended_.notify_all();
  return made;
}

void StaticBackgroundCache::erase_expired() {
  std::erase_if(entries_, [](const auto& entry) {
    return !entry.second.in_progress && entry.second.background.expired();
  });
}

}  // namespace mien::render
