#include "motion/examples/flight_examples.h"

#include "motion/gait/flight_keytimes.h"

namespace mien::motion {

namespace {

std::optional<std::array<double, gait_keytime_count>> keytimes_of_run(const Example& example) {
  if (!example.clip.loops || example.keytimes.size() != gait_keytime_count) return std::nullopt;
  return flight_keytimes(example.clip);
}

}  // namespace

bool use_flight_keytimes(std::vector<Example>& examples) {
  std::vector<std::vector<double>> found;
  for (const Example& example : examples) {
    const auto keytimes = keytimes_of_run(example);
    if (!keytimes) return false;
    found.emplace_back(keytimes->begin(), keytimes->end());
  }
  for (size_t i = 0; i < examples.size(); ++i) examples[i].keytimes = std::move(found[i]);
  return !examples.empty();
}

void match_keytimes(Example& a, Example& b) {
  std::vector<Example*> runs;
  for (Example* example : {&a, &b}) {
    if (keytimes_of_run(*example)) runs.push_back(example);
  }
  for (Example* run : runs) {
    const auto walking = cycle_of_loop(run->clip);
    const auto keytimes = runs.size() == 2 ? keytimes_of_run(*run)
                          : walking        ? std::optional(walking->keytimes)
                                           : std::nullopt;
    if (keytimes) run->keytimes.assign(keytimes->begin(), keytimes->end());
  }
}

std::vector<std::string> running_examples(const std::vector<Example>& examples) {
  std::vector<std::string> names;
  for (const Example& example : examples) {
    if (keytimes_of_run(example)) names.push_back(example.name);
  }
  return names;
}

}  // namespace mien::motion
