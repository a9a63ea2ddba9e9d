// The functions of the motion core that the page calls in its WebAssembly module. One bundle and
// one core a module; texts are UTF-8, with their length. Functions that answer 1 have made an
// answer, those that answer 0 an error in plain words: live_result() and live_result_size() give
// either.

#include <memory>
#include <string>

#include "motion/live/live_bundle.h"
#include "motion/live/live_core.h"
#include "motion/live/live_message.h"

namespace {

using namespace mien::motion;

std::unique_ptr<LiveBundle> bundle;
std::unique_ptr<LiveCore> core;
LiveSetting setting;
std::string result;

template <class Make>
int answered(Make make) {
  try {
    result = make();
    return 1;
  } catch (const std::exception& error) {
    result = error.what();
  } catch (...) {
    result = "the motion core failed";
  }
  return 0;
}

}  // namespace

extern "C" {

/// Opens the bundle whose bytes were copied to `live_room(size)`; answers its information as JSON.
int live_open(const char* bytes, std::size_t size) {
  return answered([&] {
    core.reset();
    bundle = std::make_unique<LiveBundle>(parse_live_bundle({bytes, size}));
    core = std::make_unique<LiveCore>(*bundle);
    return bundle->info;
  });
}

char* live_room(std::size_t size) { return static_cast<char*>(::operator new(size, std::nothrow)); }
void live_leave(char* room) { ::operator delete(room); }

/// Begins a setting: 0 adjectives, 1 features, 2 weights, 3 modifications.
void live_set(int kind) { setting = {static_cast<InterfaceKind>(kind), {}, {}}; }
void live_slider(const char* name, std::size_t size, double value) {
  setting.sliders.emplace_back(name, size);
  setting.values.push_back(value);
}

int live_make() {
  return answered([] { return to_message(core->make(setting)); });
}
int live_distance(const char* target, std::size_t size) {
  return answered([&] { return to_message(core->distance({target, size}, setting)); });
}
int live_example(const char* name, std::size_t size) {
  return answered([&] { return to_message(core->example({name, size})); });
}
int live_target(const char* name, std::size_t size) {
  return answered([&] { return to_message(core->target({name, size})); });
}

const char* live_result() { return result.data(); }
std::size_t live_result_size() { return result.size(); }
}
