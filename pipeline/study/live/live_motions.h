#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "motion/live/live_bundle.h"
#include "motion/live/live_core.h"
#include "pipeline/study/server/http_message.h"

namespace mien::pipeline {

/// Synthesizes motions for the pages of a server. Thread-safe: by default, as many requests as
/// there are processors are handled at once; others wait.
///
/// Routes, relative to the path at which the server mounts them:
///
///     GET  info        JSON: the options of the page (live_info)
///     GET  bundle      the bundle (motion/live/live_bundle.h), for the live core in the browser
///     POST make        {"kind": "adjectives", "sliders": ["quickness"], "values": [0.7]}
///     POST distance    {"target": "t1", …} with the members of make: D between the target and the
///                      motion of these sliders
///     POST example     {"name": "normal"}
///     POST target      {"name": "t1"}
///
/// Responses to POST are bytes (motion/live/live_message.h). Invalid requests get status 400, 404
/// or 405 and JSON with the reason. The caller is responsible for rate limits.
class LiveMotions {
 public:
  /// `at_once`: number of requests handled simultaneously; 0: one per processor.
  explicit LiveMotions(motion::LiveBundle bundle, int at_once = 0);
  LiveMotions(const LiveMotions&) = delete;
  LiveMotions& operator=(const LiveMotions&) = delete;

  const motion::LiveBundle& bundle() const { return bundle_; }

  /// Handles a request. `rest`: the path segments after the mount point.
  HttpResponse answer(const HttpRequest& request, std::span<const std::string> rest);

  /// D between a target and the motion of a slider setting, metres. Throws Error.
  motion::Distance distance(const std::string& target, const motion::LiveSetting& setting);

 private:
  /// Calls `ask` with a live core that no other request uses meanwhile.
  template <class Result>
  Result with_core(const std::function<Result(motion::LiveCore&)>& ask);
  HttpResponse answer_post(const std::string& what, const std::string& body);

  const motion::LiveBundle bundle_;
  std::mutex mutex_;
  std::condition_variable free_again_;
  std::vector<std::unique_ptr<motion::LiveCore>> free_;
};

}  // namespace mien::pipeline
