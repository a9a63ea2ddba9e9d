#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "pipeline/checks/checked_manifest.h"
#include "pipeline/commands/cli.h"
#include "pipeline/commands/installed_manifests.h"
#include "pipeline/look/set_file.h"
#include "pipeline/ratings/scales.h"

namespace mien::pipeline {

namespace {

struct CheckOptions {
  std::vector<std::string> manifests;
  bool json = false;
};

nlohmann::ordered_json as_json(const Fault& fault) {
  return {{"file", fault.place.file}, {"line", fault.place.line}, {"column", fault.place.column},
          {"path", fault.path},       {"wrong", fault.wrong},     {"remedy", fault.remedy}};
}

/// A manifest's faults, or those of a file of scales or of a set, which are called
/// <name>.scales.yaml and <name>.set.yaml.
std::vector<Fault> faults_in(const std::string& file) {
  const bool is_set = file.ends_with("set.yaml");
  if (!is_set && !file.ends_with("scales.yaml")) {
    return check_manifest(file, process_environment()).faults;
  }
  try {
    is_set ? static_cast<void>(read_set(file, file)) : static_cast<void>(read_scales(file));
    return {};
  } catch (const Faults& faults) {
    return faults.list();
  }
}

int check(const CheckOptions& options, const Console& console) {
  nlohmann::ordered_json listed = nlohmann::ordered_json::array();
  bool is_good = true;
  for (const std::string& name : options.manifests) {
    const std::string file = given_or_installed(name, console);
    const std::vector<Fault> faults = faults_in(file);
    for (const Fault& fault : faults) {
      if (options.json) {
        listed.push_back(as_json(fault));
      } else {
        console.err << to_string(fault) << '\n';
      }
    }
    is_good = is_good && faults.empty();
    if (!options.json && faults.empty()) console.out << file << ": no faults\n";
  }
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  if (options.json) {
    const nlohmann::ordered_json result = {{"faults", listed}};
    console.out << result.dump(2, ' ', false, replace) << '\n';
  }
  return is_good ? exit_done : exit_bad_input;
}

}  // namespace

void add_check_command(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("check", "Find everything wrong with a manifest, a scales file or a set");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("manifest", options->manifests, "Manifests, scales files or sets (YAML)")
      ->required();
  command->add_flag("--json", options->json, "Faults as JSON on standard output");
  command->footer(
      "\nWrites no file. Faults are told as file:line:column: path.to.key: what is wrong; how to "
      "mend it.\n\nExample:\n  mien check my.yaml");
  command->callback([&chosen, options] {
    chosen = [options](const Console& console) { return check(*options, console); };
  });
}

}  // namespace mien::pipeline
