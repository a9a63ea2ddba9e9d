#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "motion/text/shell_word.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/installed_manifests.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Comment from which editors read the schema's path.
constexpr std::string_view schema_line = "# yaml-language-server: $schema=";

/// The start of a file's leading comment, up to a full stop or colon.
std::string first_sentence(const std::string& text) {
  std::istringstream lines(text);
  std::string comment;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");)
    if (!line.starts_with(schema_line)) comment += line.substr(2) + " ";
  return comment.substr(0, std::min(comment.find(". "), comment.find(": ")));
}

void list_manifests(const fs::path& folder, const Console& console) {
  for (const std::string& name : manifest_names(folder)) {
    const std::string about = first_sentence(read_file(folder / (name + ".yaml")));
    console.out << fmt::format("{:16} {}\n", name, about);
  }
}

/// The text with an absolute path of its schema, so that an editor finds it wherever it is saved.
std::string with_schema_of(const fs::path& folder, std::string text) {
  const std::size_t end = text.find('\n');
  if (!text.starts_with(schema_line) || end == std::string::npos) return text;
  const std::string schema = text.substr(schema_line.size(), end - schema_line.size());
  return text.replace(schema_line.size(), schema.size(), (folder / schema).string());
}

/// Names of files beside `printed` that its text names, comments aside.
std::vector<std::string> files_named_in(const std::string& text, const fs::path& printed) {
  std::istringstream lines(text);
  std::string content;
  for (std::string line; std::getline(lines, line);) content += line.substr(0, line.find('#'));
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(printed.parent_path())) {
    const std::string name = entry.path().filename();
    if (content.find(" " + name) != std::string::npos) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

int show_manifest(const std::string& name, const Console& console) {
  const fs::path folder = installed_manifests();
  if (folder.empty())
    throw Error("no manifests are installed with this program",
                "install it with its manifests (share/mien/manifests beside bin)");
  if (name.empty()) {
    list_manifests(folder, console);
    return exit_done;
  }
  const auto file = find_named_file(folder, name);
  if (!file)
    throw Error("there is no manifest " + motion::in_quotes(name),
                motion::did_you_mean(name, manifest_names(folder)));
  const std::string text = read_file(*file);
  console.out << with_schema_of(folder, text);
  for (const std::string& other : files_named_in(text, *file))
    console.err << "it names a file that must be beside it: mien manifests "
                << motion::shell_path(other) << " > " << motion::shell_path(other) << '\n';
  return exit_done;
}

}  // namespace

Command manifests_command() {
  const auto name = std::make_shared<std::string>();
  return {
      .name = "manifests",
      .summary = "List the manifests installed with mien, or print one",
      .options = {argument("name", name.get(), "Manifest, or file of scales or recipes, to print")
                      .optional()},
      .notes =
          "Wherever a command takes a manifest that is not found as a file, it is looked up among "
          "these; manifests/ and .yaml may be omitted.\n\n"
          "Examples:\n"
          "  mien run quickstart\n"
          "  mien manifests quickstart > my.yaml",
      .run = [name](const Console& console) { return show_manifest(*name, console); }};
}

}  // namespace mien::pipeline
