#include "pipeline/tasks/bounded_queue.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(BoundedQueue, HandsEverythingOnInOrderAndNeverHoldsMoreThanItsCapacity) {
  BoundedQueue<int> queue(3);
  std::atomic<int> pushed = 0;
  std::atomic<int> popped = 0;
  std::atomic<int> most = 0;
  std::vector<int> taken;
  std::thread taker([&] {
    int value = 0;
    while (queue.pop(value)) {
      taken.push_back(value);
      ++popped;
    }
  });
  for (int i = 0; i < 10000; ++i) {
    queue.push(i);
    ++pushed;
    most = std::max(most.load(), pushed - popped);
  }
  queue.close();
  taker.join();
  ASSERT_EQ(taken.size(), 10000u);
  for (int i = 0; i < 10000; ++i) EXPECT_EQ(taken[static_cast<std::size_t>(i)], i);
  // One more may be in the taker's hands, and one popped but not counted yet.
  EXPECT_LE(most, 5);
}

TEST(BoundedQueue, LetsNobodyWaitOnceItIsClosed) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  ASSERT_TRUE(queue.push(std::make_unique<int>(1)));
  std::thread pusher([&] { EXPECT_FALSE(queue.push(std::make_unique<int>(2))); });
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  queue.close();
  pusher.join();
  std::unique_ptr<int> value;
  EXPECT_TRUE(queue.pop(value));
  EXPECT_EQ(*value, 1);
  EXPECT_FALSE(queue.pop(value));
}

}  // namespace
}  // namespace mien::pipeline
