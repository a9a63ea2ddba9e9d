#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "render/light/standing_set.h"

namespace mien::render {

/// The standing sets of several tracers that work side by side: each is worked out by the first
/// that asks for it and lent to all, as long as any of them draws with it. Outlives the tracers.
class StandingSets {
 public:
  /// Shared by the tracers that draw with it, because none of them knows who will be the last.
  using Lent = std::shared_ptr<const StandingSet>;

  /// The set of that name (standing_name), made by `make` unless it is there. While another thread
  /// makes it, this one waits; when that fails, it makes it itself. Throws what `make` throws.
  Lent lend(const std::string& name, const std::function<StandingSet()>& make);

 private:
  struct Entry {
    std::weak_ptr<const StandingSet> set;
    bool in_making = false;
  };

  void forget_returned();

  std::mutex mutex_;
  std::condition_variable ended_;  // the making of a set
  std::map<std::string, Entry> entries_;
};

/// Finds the light of a set with standing solids that was drawn before, by the set's name, or draws
/// it and keeps it for the next time. What it gives is what `draw` gives, to the bit.
using KeepLight = std::function<Film(const std::string& name, const std::function<Film()>& draw)>;

}  // namespace mien::render
