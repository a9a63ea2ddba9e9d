#include "pipeline/farm/open_job_description.h"

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "pipeline/farm/submission.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Text between double braces is replaced where the template is used, and nothing undoes that.
std::string plain(const std::string& text) {
  if (text.find("{{") == std::string::npos && text.find("}}") == std::string::npos) return text;
  throw Error(
      "Open Job Description cannot name \"" + text + "\", because it contains double braces",
      "rename it");
}

/// A text, not a path: an absolute path may not be the default of one.
ordered_json parameter(const char* name, const char* description, const std::string& value) {
  return {
      {"name", name}, {"type", "STRING"}, {"description", description}, {"default", plain(value)}};
}

ordered_json parameters(const StudyCall& call) {
  return {parameter("Mien", "The program", call.program.string()),
          parameter("Manifest", "Items to make", call.manifest.string()),
          parameter("Out", "Folder of all studies, shared by all workers", call.out.string())};
}

ordered_json action(std::vector<std::string> arguments, const StudyCall& call,
                    const JobRequest& request) {
  arguments.insert(arguments.end(),
                   {"--out", "{{Param.Out}}", "--jobs", std::to_string(request.processors)});
  if (!call.quality.empty()) arguments.insert(arguments.end(), {"--quality", call.quality});
  return {{"command", "{{Param.Mien}}"},
          {"args", arguments},
          {"cancelation", {{"mode", "NOTIFY_THEN_TERMINATE"}, {"notifyPeriodInSeconds", 30}}}};
}

ordered_json requirements(const JobRequest& request) {
  return {{"amounts", {{{"name", "amount.worker.vcpu"}, {"min", request.processors}}}}};
}

ordered_json stage_step(const Stage& stage, const std::string& before, const StudyCall& call,
                        const JobRequest& request) {
  SubmissionJob lines;
  lines.elements = stage.elements;
  ordered_json step = {{"name", stage.name}};
  if (!before.empty()) step["dependencies"] = {{{"dependsOn", before}}};
  step["hostRequirements"] = requirements(request);
  step["parameterSpace"] = {{"taskParameterDefinitions",
                             {{{"name", "Element"},
                               {"type", "INT"},
                               {"range", "1-" + std::to_string(stage.elements.size())}}}}};
  step["script"] = {{"actions",
                     {{"onRun", action({"farm", "worker", "{{Param.Manifest}}", "--list",
                                        "{{Task.File.Items}}", "--line", "{{Task.Param.Element}}"},
                                       call, request)}}},
                    {"embeddedFiles",
                     {{{"name", "Items"},
                       {"type", "TEXT"},
                       {"filename", stage.name + ".tasks"},
                       {"data", plain(list_text(lines))}}}}};
  return step;
}

ordered_json rest_step(const std::string& before, const StudyCall& call,
                       const JobRequest& request) {
  ordered_json step = {{"name", "rest"}};
  if (!before.empty()) step["dependencies"] = {{{"dependsOn", before}}};
  step["hostRequirements"] = requirements(request);
  step["script"] = {{"actions", {{"onRun", action({"run", "{{Param.Manifest}}"}, call, request)}}}};
  return step;
}

}  // namespace

ordered_json open_job_template(const std::vector<Stage>& stages, const StudyCall& call,
                               const JobRequest& request) {
  ordered_json steps = ordered_json::array();
  std::string before;
  for (const Stage& stage : stages) {
    steps.push_back(stage_step(stage, before, call, request));
    before = stage.name;
  }
  steps.push_back(rest_step(before, call, request));
  return {{"specificationVersion", "jobtemplate-2023-09"},
          {"name", "mien " + call.study},
          {"description",
           "Makes the study " + call.study +
               ": motions, frames, films, sheets, report. Existing results are not made again."},
          {"parameterDefinitions", parameters(call)},
          {"steps", steps}};
}

std::string open_job_text(const ordered_json& job, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".json" || ending == ".yaml" || ending == ".yml") return job.dump(2) + "\n";
  throw Error("-o " + file.string() + ": a job template must be a .json or .yaml file",
              "use one of these extensions");
}

}  // namespace mien::pipeline
