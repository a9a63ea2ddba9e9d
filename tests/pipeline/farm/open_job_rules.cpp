#include "pipeline/farm/open_job_rules.h"

#include <regex>
#include <set>

#include <nlohmann/json.hpp>

namespace mien::test {

namespace {

using nlohmann::json;

const std::regex identifier("[A-Za-z_][A-Za-z0-9_]{0,63}");

class Rules {
 public:
  std::vector<std::string> breaches;

  void check_job(const json& job) {
    keys("job", job, {"specificationVersion", "name", "steps"},
         {"$schema", "description", "parameterDefinitions"});
    if (!breaches.empty()) return;
    expect(job["specificationVersion"] == "jobtemplate-2023-09", "specificationVersion");
    plain_text("name", job["name"], 128);
    if (job.contains("description")) text("description", job["description"], 2048);
    if (job.contains("parameterDefinitions")) check_parameters(job["parameterDefinitions"]);
    expect(job["steps"].is_array() && !job["steps"].empty(), "steps");
    for (const json& step : job["steps"]) check_step(step);
    check_order(job["steps"]);
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) breaches.push_back(what);
  }

  void keys(const std::string& where, const json& map, const std::set<std::string>& needed,
            const std::set<std::string>& allowed) {
    if (!map.is_object()) return breaches.push_back(where + ": no map");
    for (const std::string& key : needed) expect(map.contains(key), where + ": lacks " + key);
    for (const auto& [key, value] : map.items()) {
      expect(needed.contains(key) || allowed.contains(key), where + ": unknown " + key);
    }
  }

  void text(const std::string& where, const json& value, std::size_t most) {
    expect(value.is_string() && !value.get<std::string>().empty() &&
               value.get<std::string>().size() <= most,
           where + ": no text of 1 to " + std::to_string(most));
  }

  /// Without control characters (Unicode's category Cc).
  void plain_text(const std::string& where, const json& value, std::size_t most) {
    text(where, value, most);
    if (!value.is_string()) return;
    for (const unsigned char letter : value.get<std::string>()) {
      expect(letter >= 0x20 && letter != 0x7f, where + ": a control character");
    }
  }

  void check_parameters(const json& parameters) {
    expect(parameters.is_array() && !parameters.empty() && parameters.size() <= 50, "parameters");
    for (const json& parameter : parameters) {
      keys("parameter", parameter, {"name", "type"}, {"description", "default"});
      expect(parameter.value("type", "") == "STRING", "parameter: another type");
      const std::string name = parameter.value("name", "");
      expect(std::regex_match(name, identifier), "parameter: name " + name);
      for (const char* scope : {"Param.", "RawParam."}) {
        expect(known_.insert(scope + name).second, "parameter: " + name + " twice");
      }
      if (parameter.contains("default")) text("default", parameter["default"], 1024);
    }
  }

  void check_step(const json& step) {
    keys("step", step, {"name", "script"},
         {"description", "dependencies", "hostRequirements", "parameterSpace"});
    plain_text("step name", step.value("name", json()), 64);
    const std::set<std::string> before = known_;
    if (step.contains("hostRequirements")) check_requirements(step["hostRequirements"]);
    if (step.contains("parameterSpace")) check_space(step["parameterSpace"]);
    if (step.contains("script")) check_script(step["script"]);
    known_ = before;
  }

  void check_requirements(const json& requirements) {
    keys("hostRequirements", requirements, {"amounts"}, {});
    for (const json& amount : requirements.value("amounts", json::array())) {
      keys("amount", amount, {"name"}, {"min", "max"});
      expect(std::regex_match(amount.value("name", ""),
                              std::regex("([A-Za-z_]\\w*:)?amount(\\.[A-Za-z_]\\w*)+")),
             "amount: name");
      expect(amount.contains("min") || amount.contains("max"), "amount: neither min nor max");
      for (const char* end : {"min", "max"}) {
        expect(!amount.contains(end) || (amount[end].is_number() && amount[end] >= 0), "amount");
      }
    }
  }

  void check_space(const json& space) {
    keys("parameterSpace", space, {"taskParameterDefinitions"}, {});
    const json& parameters = space.value("taskParameterDefinitions", json::array());
    expect(!parameters.empty() && parameters.size() <= 16, "taskParameterDefinitions");
    for (const json& parameter : parameters) {
      keys("task parameter", parameter, {"name", "type", "range"}, {});
      const std::string name = parameter.value("name", "");
      expect(std::regex_match(name, identifier), "task parameter: name");
      expect(parameter.value("type", "") == "INT", "task parameter: another type");
      std::smatch range;
      const std::string told = parameter.value("range", "");
      expect(std::regex_match(told, range, std::regex(R"((\d{1,9})-(\d{1,9}))")) &&
                 std::stoi(range[1]) <= std::stoi(range[2]),
             "task parameter: range " + told);
      known_.insert("Task.Param." + name);
    }
  }

  void check_script(const json& script) {
    keys("script", script, {"actions"}, {"embeddedFiles"});
    if (script.contains("embeddedFiles")) {
      expect(!script["embeddedFiles"].empty(), "embeddedFiles");
      for (const json& file : script["embeddedFiles"]) check_file(file);
    }
    keys("actions", script.value("actions", json()), {"onRun"}, {});
    if (breaches.empty()) check_action(script["actions"]["onRun"]);
  }

  void check_file(const json& file) {
    keys("embedded file", file, {"name", "type", "data"}, {"filename", "runnable"});
    const std::string name = file.value("name", "");
    expect(std::regex_match(name, identifier), "embedded file: name");
    expect(file.value("type", "") == "TEXT", "embedded file: type");
    const std::string called = file.value("filename", "x");
    expect(!called.empty() && called.size() <= 64 && called.find('/') == std::string::npos,
           "embedded file: filename");
    text("data", file.value("data", json()), std::string::npos);
    known_.insert("Task.File." + name);
    references("data", file.value("data", ""));
  }

  void check_action(const json& action) {
    keys("action", action, {"command"}, {"args", "timeout", "cancelation"});
    plain_text("command", action.value("command", json()), std::string::npos);
    references("command", action.value("command", ""));
    for (const json& argument : action.value("args", json::array())) {
      plain_text("argument", argument, std::string::npos);
      if (argument.is_string()) references("argument", argument);
    }
    if (!action.contains("cancelation")) return;
    const json& method = action["cancelation"];
    keys("cancelation", method, {"mode"}, {"notifyPeriodInSeconds"});
    const std::string mode = method.value("mode", "");
    expect(mode == "TERMINATE" || mode == "NOTIFY_THEN_TERMINATE", "cancelation: mode");
    const int period = method.value("notifyPeriodInSeconds", 30);
    expect(period > 0 && period <= 600, "cancelation: period");
  }

  /// What stands between double braces is known there.
  void references(const std::string& where, const std::string& text) {
    static const std::regex reference(R"(\{\{\s*([^}]*?)\s*\}\})");
    for (std::sregex_iterator at(text.begin(), text.end(), reference), end; at != end; ++at) {
      expect(known_.contains((*at)[1]), where + ": unknown " + (*at)[1].str());
    }
    const std::string rest = std::regex_replace(text, reference, "");
    expect(rest.find("{{") == std::string::npos && rest.find("}}") == std::string::npos,
           where + ": double braces");
  }

  /// Names differ, and steps depend on others without going round in a circle (here: on earlier
  /// ones).
  void check_order(const json& steps) {
    std::set<std::string> names;
    for (const json& step : steps) {
      if (step.contains("dependencies")) {
        expect(!step["dependencies"].empty(), "dependencies");
        for (const json& one : step["dependencies"]) {
          keys("dependency", one, {"dependsOn"}, {});
          expect(names.contains(one.value("dependsOn", "")), "dependency on no earlier step");
        }
      }
      expect(names.insert(step.value("name", "")).second, "two steps of one name");
    }
  }

  std::set<std::string> known_ = {"Session.WorkingDirectory"};
};

}  // namespace

std::vector<std::string> open_job_breaches(const json& job) {
  Rules rules;
  rules.check_job(job);
  return std::move(rules.breaches);
}

}  // namespace mien::test
