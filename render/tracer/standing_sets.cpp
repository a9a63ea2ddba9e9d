#include "render/tracer/standing_sets.h"

namespace mien::render {

StandingSets::Lent StandingSets::lend(const std::string& name,
                                      const std::function<StandingSet()>& make) {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [&] {
    const auto entry = entries_.find(name);
    return entry == entries_.end() || !entry->second.in_making;
  });
  if (Lent there = entries_[name].set.lock()) return there;
  entries_[name].in_making = true;
  lock.unlock();
  Lent made;
  try {
    made = std::make_shared<const StandingSet>(make());
  } catch (...) {
    lock.lock();
    entries_.erase(name);
    ended_.notify_all();
    throw;
  }
  lock.lock();
  forget_returned();
  entries_[name] = {made, false};
  ended_.notify_all();
  return made;
}

void StandingSets::forget_returned() {
  std::erase_if(entries_, [](const auto& entry) {
    return !entry.second.in_making && entry.second.set.expired();
  });
}

}  // namespace mien::render
