#include "pipeline/study/live/live_motions.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/live/live_message.h"
#include "motion/text/json_depth.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr std::size_t most_sliders = 1000;
constexpr std::size_t longest_name = 200;

HttpResponse refused(const std::string& wrong, const std::string& remedy) {
  return http_refusal(400, "bad request", wrong, remedy);
}

HttpResponse bytes_answer(std::string bytes) {
  HttpResponse response;
  response.type = "application/octet-stream";
  response.body = std::move(bytes);
  return response;
}

/// Thrown for a request with an invalid body.
struct BadRequest {
  std::string wrong;
};

std::string name_in(const json& value, const char* what) {
  if (!value.is_string() || value.get_ref<const std::string&>().size() > longest_name)
    throw BadRequest{std::string(what) + " is not a valid name"};
  return value.get<std::string>();
}

const json& part(const json& body, const char* name) {
  const auto found = body.find(name);
  if (found == body.end()) throw BadRequest{"\"" + std::string(name) + "\" is missing"};
  return *found;
}

const json& list_part(const json& body, const char* name) {
  const json& list = part(body, name);
  if (!list.is_array() || list.size() > most_sliders)
    throw BadRequest{"\"" + std::string(name) + "\" is not a list, or is too long"};
  return list;
}

motion::LiveSetting setting_in(const json& body) {
  motion::LiveSetting setting;
  const auto kind = meaning_of(motion::interface_kinds, name_in(part(body, "kind"), "\"kind\""));
  if (!kind) throw BadRequest{"\"kind\" is none of adjectives, features, weights, modifications"};
  setting.kind = *kind;
  for (const json& slider : list_part(body, "sliders"))
    setting.sliders.push_back(name_in(slider, "a slider"));
  for (const json& value : list_part(body, "values")) {
    if (!value.is_number()) throw BadRequest{"a value is not a number"};
    setting.values.push_back(value.get<double>());
  }
  return setting;
}

/// Parses JSON up to a nesting depth that valid requests do not exceed.
json parsed(const std::string& body) {
  constexpr std::size_t deepest = 5;
  if (motion::is_nested_deeper(body, deepest)) throw BadRequest{"the JSON is nested too deep"};
  json given = json::parse(body, nullptr, false);
  if (!given.is_object()) throw BadRequest{"the body is not a JSON object"};
  return given;
}

}  // namespace

LiveMotions::LiveMotions(motion::LiveBundle bundle, int at_once) : bundle_(std::move(bundle)) {
  const int processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int cores = at_once > 0 ? at_once : processors;
  for (int i = 0; i < cores; ++i) free_.push_back(std::make_unique<motion::LiveCore>(bundle_));
}

template <class Result>
Result LiveMotions::with_core(const std::function<Result(motion::LiveCore&)>& ask) {
  std::unique_ptr<motion::LiveCore> core;
  {
    std::unique_lock lock(mutex_);
    free_again_.wait(lock, [this] { return !free_.empty(); });
    core = std::move(free_.back());
    free_.pop_back();
  }
  struct Return {
    LiveMotions& motions;
    std::unique_ptr<motion::LiveCore>& core;
    ~Return() {
      const std::lock_guard lock(motions.mutex_);
      motions.free_.push_back(std::move(core));
      motions.free_again_.notify_one();
    }
  } give_back{*this, core};
  return ask(*core);
}

motion::Distance LiveMotions::distance(const std::string& target,
                                       const motion::LiveSetting& setting) {
  return with_core<motion::Distance>(
      [&](motion::LiveCore& core) { return core.distance(target, setting); });
}

HttpResponse LiveMotions::answer_post(const std::string& what, const std::string& body) {
  const json given = parsed(body);
  if (what == "distance")
    return bytes_answer(motion::to_message(
        distance(name_in(part(given, "target"), "\"target\""), setting_in(given))));
  const motion::LiveMotion made = with_core<motion::LiveMotion>([&](motion::LiveCore& core) {
    if (what == "make") return core.make(setting_in(given));
    const std::string name = name_in(part(given, "name"), "\"name\"");
    return what == "example" ? core.example(name) : core.target(name);
  });
  return bytes_answer(motion::to_message(made));
}

HttpResponse LiveMotions::answer(const HttpRequest& request, std::span<const std::string> rest) {
  const std::string what = rest.size() == 1 ? rest[0] : "";
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (what == "info" && reads) return http_json(bundle_.info);
  if (what == "bundle" && reads) return bytes_answer(motion::to_bytes(bundle_));
  const bool is_made =
      what == "make" || what == "distance" || what == "example" || what == "target";
  if (!is_made && what != "info" && what != "bundle")
    return http_refusal(404, "not found", "there is nothing with that name", "go back");
  if (!is_made || request.method != "POST")
    return http_refusal(405, "not allowed", "this method is not allowed",
                        is_made ? "use POST" : "use GET");
  try {
    return answer_post(what, request.body);
  } catch (const BadRequest& bad) {
    return refused(bad.wrong, "load the page again");
  } catch (const Error& error) {
    return refused(error.what(), "");
  }
}

}  // namespace mien::pipeline
