#include "pipeline/tasks/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "pipeline/tasks/task_graph.h"

namespace mien::pipeline {

void for_each_of(std::size_t count, int threads, const std::stop_token& stop,
                 const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto take = [&] {
    try {
      for (std::size_t i = next++; i < count && !stop.stop_requested(); i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard guard(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t more = std::min<std::size_t>(count, static_cast<std::size_t>(threads));
    for (std::size_t k = 1; k < more; ++k) others.emplace_back(take);
    take();
  }
  if (failure) std::rethrow_exception(failure);
  if (stop.stop_requested()) throw Interrupted{};
}

void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work) {
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for_each_of(count, processors, {}, work);
}

}  // namespace mien::pipeline
