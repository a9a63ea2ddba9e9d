#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace mien::pipeline {

/// Calls `work` with 0 … count − 1 on so many threads, each index once. After a stop request no
/// more is begun, and Interrupted is thrown; what `work` throws is thrown when all threads have
/// ended.
void for_each_of(std::size_t count, int threads, const std::stop_token& stop,
                 const std::function<void(std::size_t)>& work);

/// The same on as many threads as there are processors, of what is soon done.
void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace mien::pipeline
