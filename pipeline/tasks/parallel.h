#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace mien::pipeline {

/// Calls `work` once with each index 0 … count − 1, on at most `threads` threads. After a stop
/// request or an exception of `work`, no further call is started. When all threads have ended, the
/// exception is rethrown or, after a stop request, Interrupted is thrown.
void for_each_of(std::size_t count, int threads, const std::stop_token& stop,
                 const std::function<void(std::size_t)>& work);

/// Calls `work` once with each index 0 … count − 1, on at most as many threads as there are
/// processors. For short work, since it cannot be stopped.
void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace mien::pipeline
