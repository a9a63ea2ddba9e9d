#pragma once

#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/study/studio/studio_service.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {

/// The quickstart's text with a change.
inline std::string brisker(std::string quickstart) {
  return quickstart.replace(quickstart.find("quickness: 0.7"), 14, "quickness: 0.9");
}

/// The quickstart in a studio that is asked without a network.
class Studio : public testing::Test {
 protected:
  Studio()
      : file_((write_file(folder_.path() / "my.yaml",
                          read_file(std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" /
                                    "quickstart.yaml")),
               folder_.path() / "my.yaml"),
              process_environment()),
        service_(file_,
                 {{"index.html", {"<p>", "text/html"}}, {"studio.js", {"1", "text/javascript"}}},
                 folder_.path() / "out", 2) {
    service_.set_port(4711);
  }

  HttpRequest request(const std::string& method, std::vector<std::string> path,
                      std::string body = "") const {
    path.insert(path.begin(), service_.link());
    HttpRequest asked{.method = method, .path = std::move(path), .body = std::move(body)};
    asked.headers["host"] = "127.0.0.1:4711";
    if (method == "POST") asked.headers["content-type"] = "application/json";
    asked.address = "127.0.0.1";
    return asked;
  }

  HttpResponse get(std::vector<std::string> path) {
    return service_.answer(request("GET", std::move(path)));
  }
  HttpResponse post(const std::string& what, const nlohmann::ordered_json& body) {
    return service_.answer(request("POST", {what}, body.dump()));
  }
  nlohmann::ordered_json document() const { return file_.state().document; }

  /// The JSON before a motion.
  static nlohmann::ordered_json head_of(const HttpResponse& response) {
    std::uint32_t length = 0;
    std::memcpy(&length, response.body.data(), 4);
    EXPECT_EQ(response.body.substr(4 + length, 4), "MOVE");
    return nlohmann::ordered_json::parse(response.body.substr(4, length));
  }

  /// Waits for a job and returns its final state.
  nlohmann::ordered_json ended(int job) {
    for (;;) {
      const nlohmann::ordered_json job_state =
          nlohmann::ordered_json::parse(get({"jobs", std::to_string(job)}).body);
      if (job_state["state"] != "running") return job_state;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

  test::TemporaryFolder folder_;
  ManifestFile file_;
  StudioService service_;
};

}  // namespace mien::pipeline
