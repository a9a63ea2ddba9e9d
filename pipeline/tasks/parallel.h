#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace mien::pipeline {

/// Calls `work` once with each index 0 … count − 1, on `threads` threads. After a stop request no
/// further call is started and Interrupted is thrown. An exception of `work` is rethrown when all
/// threads have ended.
void for_each_of(std::size_t count, int threads, const std::stop_token& stop,
                 const std::function<void(std::size_t)>& work);

/// Calls `work` once with each index 0 … count − 1, on as many threads as there are processors. For
/// short work, since it cannot be stopped.
void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace mien::pipeline
