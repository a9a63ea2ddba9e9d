#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/commands/cli.h"
#include "pipeline/production/archive/tar_archive.h"
#include "pipeline/study/server/database.h"
#include "pipeline/study/server/http_server.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

int show_versions(bool as_json, const Console& console) {
  std::vector<std::pair<std::string, std::string>> versions = library_versions();
  // Of no artifact's bytes, but of archives' and of those who serve.
  versions.emplace_back("libarchive", archive_library());
  versions.emplace_back("Boost", http_library());
  versions.emplace_back("SQLite", database_library());
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

Command version_command() {
  const auto as_json = std::make_shared<bool>(false);
  return {.name = "version",
          .summary = "Show the versions of mien and its libraries",
          .options = {flag("--json", as_json.get(), "As JSON")},
          .run = [as_json](const Console& console) { return show_versions(*as_json, console); }};
}

}  // namespace mien::pipeline
