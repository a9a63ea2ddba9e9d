#include "pipeline/study/live/live_motions.h"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/live/live_message.h"
#include "pipeline/study/live/live_study.h"

namespace mien::pipeline {
namespace {

motion::LiveBundle served_bundle() {
  const Manifest manifest = test::live_manifest("{method: reach}");
  Motions motions(manifest);
  LiveChoice choice = live_choice(manifest);
  choice.targets = {"by-weights"};
  return live_bundle(manifest, motions, choice);
}

class LiveRoutes : public testing::Test {
 protected:
  HttpResponse ask(const std::string& method, const std::vector<std::string>& rest,
                   const std::string& body = "") {
    HttpRequest request;
    request.method = method;
    request.body = body;
    return live.answer(request, rest);
  }
  static double double_at(const std::string& bytes, std::size_t at) {
    double value = 0.0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }
  LiveMotions live{served_bundle()};
};

TEST_F(LiveRoutes, AnswerWithWhatTheCoreMakes) {
  const auto info = nlohmann::json::parse(ask("GET", {"info"}).body);
  EXPECT_EQ(info["targets"][0], "by-weights");
  EXPECT_EQ(ask("GET", {"bundle"}).body, motion::to_bytes(live.bundle()));
  motion::LiveCore core(live.bundle());
  const motion::LiveSetting setting{motion::InterfaceKind::adjectives, {"quickness"}, {0.7}};
  const HttpResponse made =
      ask("POST", {"make"}, R"({"kind":"adjectives","sliders":["quickness"],"values":[0.7]})");
  EXPECT_EQ(made.status, 200);
  EXPECT_EQ(made.body, motion::to_message(core.make(setting)));
  const HttpResponse distance =
      ask("POST", {"distance"},
          R"({"target":"by-weights","kind":"adjectives","sliders":["quickness"],"values":[0.7]})");
  EXPECT_EQ(double_at(distance.body, 8), core.distance("by-weights", setting).mean);
  EXPECT_EQ(ask("POST", {"target"}, R"({"name":"by-weights"})").body.substr(0, 4), "MOVE");
  EXPECT_EQ(ask("POST", {"example"}, R"({"name":"sad"})").body.substr(0, 4), "MOVE");
}

TEST_F(LiveRoutes, RefuseWhatIsNoRequest) {
  EXPECT_EQ(ask("GET", {}).status, 404);
  EXPECT_EQ(ask("GET", {"info", ""}).status, 404);
  EXPECT_EQ(ask("GET", {"passwd"}).status, 404);
  EXPECT_EQ(ask("GET", {"make"}).status, 405);
  EXPECT_EQ(ask("POST", {"info"}).status, 405);
  EXPECT_EQ(ask("PUT", {"make"}, "{}").status, 405);
  const std::string deep(20000, '[');
  std::string many = R"({"kind":"weights","sliders":[)";
  for (int i = 0; i < 2000; ++i) many += R"("sad",)";
  const std::string bodies[] = {
      "",
      "{",
      "null",
      "[]",
      "7",
      deep,
      R"({"kind":)" + deep,
      R"({"kind":"magic","sliders":[],"values":[]})",
      R"({"kind":7,"sliders":[],"values":[]})",
      R"({"kind":"weights"})",
      R"({"kind":"weights","sliders":"sad","values":[1]})",
      R"({"kind":"weights","sliders":[7],"values":[1]})",
      R"({"kind":"weights","sliders":["sad"],"values":["1"]})",
      R"({"kind":"weights","sliders":["sad"],"values":[]})",
      R"({"kind":"weights","sliders":["sad"],"values":[-1]})",
      R"({"kind":"weights","sliders":["sad"],"values":[1e308]})",
      R"({"kind":"weights","sliders":["sad"],"values":[1e999]})",
      R"({"kind":"weights","sliders":["nobody"],"values":[1]})",
      R"({"kind":"adjectives","sliders":[],"values":[]})",
      R"({"kind":"features","sliders":["quickness"],"values":[0.5]})",
      R"({"kind":"weights","sliders":[")" + std::string(500, 'x') + R"("],"values":[1]})",
      many + R"("sad"],"values":[]})",
      "{\"kind\":\"\xff\xfe\",\"sliders\":[],\"values\":[]}",
  };
  for (const std::string& body : bodies) {
    for (const char* what : {"make", "distance", "example", "target"}) {
      const HttpResponse refused = ask("POST", {what}, body);
      EXPECT_EQ(refused.status, 400) << what << " " << body.substr(0, 80);
      EXPECT_TRUE(nlohmann::json::parse(refused.body).contains("wrong"));
    }
  }
}

TEST_F(LiveRoutes, MayBeAskedByMany) {
  const std::string asked = R"({"kind":"features","sliders":["step-length"],"values":[0.4]})";
  const std::string expected = ask("POST", {"make"}, asked).body;
  std::vector<std::thread> many;
  for (int i = 0; i < 6; ++i) {
    many.emplace_back([&] {
      for (int k = 0; k < 3; ++k) EXPECT_EQ(ask("POST", {"make"}, asked).body, expected);
    });
  }
  for (std::thread& one : many) one.join();
}

}  // namespace
}  // namespace mien::pipeline
