#include "pipeline/commands/line/installed_manifests.h"

#include <algorithm>
#include <system_error>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

}  // namespace

fs::path manifests_beside(const fs::path& program) {
  const fs::path folder = program.parent_path();
  const fs::path installed = folder.parent_path() / "share/mien/manifests";
  const fs::path of_the_tree = folder.parent_path().parent_path() / "manifests";
  for (const fs::path& candidate : {installed, of_the_tree})
    if (is_file(candidate / "mien.schema.json")) return candidate;
  return {};
}

fs::path installed_manifests() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : manifests_beside(program);
}

std::vector<std::string> manifest_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path name = entry.path().filename();
    if (name.extension() == ".yaml" && !name.stem().has_extension()) names.push_back(name.stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<fs::path> find_named_file(const fs::path& folder, const std::string& name) {
  const fs::path wanted(name);
  if (folder.empty() || !wanted.has_filename()) return std::nullopt;
  if (wanted.has_parent_path() && wanted.parent_path() != "manifests") return std::nullopt;
  for (const std::string& ending : {std::string(), std::string(".yaml")}) {
    const fs::path file = folder / (wanted.filename().string() + ending);
    if (is_file(file)) return file;
  }
  return std::nullopt;
}

std::string resolve_input_file(const std::string& name, const Console& console) {
  if (is_file(name)) return name;
  const auto file = find_named_file(installed_manifests(), name);
  if (!file) return name;
  console.err << "using " << file->string() << '\n';
  return file->string();
}

std::string resolve_manifest(const std::string& name, const Console& console) {
  const std::string file = resolve_input_file(name, console);
  const bool is_word = !fs::path(file).has_parent_path() && !fs::path(file).has_extension();
  std::error_code error;
  if (!is_word || fs::exists(file, error)) return file;
  throw Error("there is neither a file nor a manifest " + motion::in_quotes(name),
              motion::did_you_mean(name, manifest_names(installed_manifests())));
}

}  // namespace mien::pipeline
