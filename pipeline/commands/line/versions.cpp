#include <memory>

#include <nlohmann/json.hpp>

#include "pipeline/commands/line/program.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

using Versions = std::vector<std::pair<std::string, std::string>>;

int show_versions(const Versions& more, bool as_json, const Console& console) {
  Versions versions = library_versions();
  versions.insert(versions.end(), more.begin(), more.end());
  if (!as_json) {
    console.out << "mien " << program_version() << '\n';
    for (const auto& [name, version] : versions)
      console.out << "  " << name << ' ' << version << '\n';
    return exit_done;
  }
  nlohmann::ordered_json libraries;
  for (const auto& [name, version] : versions) libraries[name] = version;
  nlohmann::ordered_json result = {{"mien", program_version()}, {"libraries", libraries}};
  console.out << result.dump(2) << '\n';
  return exit_done;
}

}  // namespace

Command version_command(std::string summary, Versions more) {
  const auto as_json = std::make_shared<bool>(false);
  return {.name = "version",
          .summary = std::move(summary),
          .options = {flag("--json", as_json.get(), "As JSON")},
          .run = [as_json, more = std::move(more)](const Console& console) {
            return show_versions(more, *as_json, console);
          }};
}

}  // namespace mien::pipeline
