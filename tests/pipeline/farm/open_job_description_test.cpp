#include "pipeline/farm/open_job_description.h"

#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "pipeline/farm/open_job_rules.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using test::open_job_breaches;

const StudyCall strange_call{
    "/opt/my mien/mien", "/walks: a \"study\".yaml", "/shared", "/", "walks", "draft"};

ordered_json template_of_two() {
  const std::vector<Stage> stages = {
      {"frames", {{{"film:a[1/2]"}, 60, 5}, {{"film:a[2/2]"}, 60, 5}, {{"film:b"}, 60, 9}}},
      {"films", {{{"film:a", "clip:a"}, 60, 10}}}};
  JobRequest request;
  request.processors = 2;
  return open_job_template(stages, strange_call, request);
}

TEST(OpenJob, ConformsToTheSpecification) {
  const json job = template_of_two();
  for (const std::string& breach : open_job_breaches(job)) ADD_FAILURE() << breach;
  EXPECT_EQ(job["steps"].size(), 3u);
  EXPECT_EQ(job["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0]["range"], "1-3");
  EXPECT_EQ(job["steps"][0]["script"]["embeddedFiles"][0]["data"],
            "film:a[1/2]\nfilm:a[2/2]\nfilm:b\n");
  EXPECT_EQ(job["steps"][2]["dependencies"][0]["dependsOn"], "films");
}

TEST(OpenJob, IsHeldAgainstRulesThatCanBeBroken) {
  const std::vector<std::function<void(json&)>> breaks = {
      [](json& job) { job["specificationVersion"] = "jobtemplate-2022-01"; },
      [](json& job) { job["name"] = "two\nlines"; },
      [](json& job) { job["name"] = std::string(129, 'x'); },
      [](json& job) { job["more"] = 1; },
      [](json& job) { job["steps"] = json::array(); },
      [](json& job) { job["steps"][1]["name"] = job["steps"][0]["name"]; },
      [](json& job) { job["steps"][1]["dependencies"][0]["dependsOn"] = "nobody"; },
      [](json& job) { job["steps"][0]["dependencies"] = json::array(); },
      [](json& job) { job["parameterDefinitions"][0]["name"] = "my mien"; },
      [](json& job) { job["parameterDefinitions"][1] = job["parameterDefinitions"][0]; },
      [](json& job) {
        job["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0]["range"] = "3-1";
      },
      [](json& job) { job["steps"][0]["script"]["embeddedFiles"][0]["filename"] = "a/b"; },
      [](json& job) { job["steps"][0]["script"]["actions"]["onRun"]["args"][0] = "{{Param.No}}"; },
      [](json& job) { job["steps"][0]["script"]["actions"]["onRun"].erase("command"); },
      [](json& job) {
        job["steps"][2]["script"]["actions"]["onRun"]["args"].push_back("{{Task.File.Items}}");
      },
      [](json& job) { job["steps"][0]["hostRequirements"]["amounts"][0].erase("min"); },
  };
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    json job = template_of_two();
    breaks[i](job);
    EXPECT_FALSE(open_job_breaches(job).empty()) << "number " << i;
  }
}

TEST(OpenJob, IsJsonWhateverTheFilesEndingOfTheTwo) {
  const ordered_json job = template_of_two();
  for (const char* file : {"a.json", "a.job.yaml", "a.yml"})
    EXPECT_EQ(ordered_json::parse(open_job_text(job, file)), job);
  EXPECT_THROW(open_job_text(job, "a.txt"), Error);
}

TEST(OpenJob, RefusesNamesThatItWouldReplace) {
  StudyCall strange = strange_call;
  strange.out = "/shared/{{Param.Out}}";
  EXPECT_THROW(open_job_template({}, strange, {}), Error);
}

}  // namespace
}  // namespace mien::pipeline
