#include "pipeline/commands/regress/study_baseline.h"

#include <chrono>

#include "motion/text/shell_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/tasks/command_run.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes git_limit{5};

CommandResult git(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", folder.empty() ? "." : folder.string()});
  return run_command(words, git_limit);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Default folder of a study's baseline: baselines/<study> next to the manifest.
fs::path usual_baseline(const Manifest& manifest) {
  return manifest.file.parent_path() / "baselines" / manifest.study;
}

/// Creates links in `tree`, a copy of the file system's root, from the folder's location to the
/// siblings of the folder itself, so that relative paths in its files can be resolved there.
void link_surroundings(const fs::path& folder, const fs::path& tree) {
  fs::path level = folder.root_path();
  for (const fs::path& next : folder.relative_path()) {
    fs::create_directories(tree / level.relative_path());
    constexpr auto skip = fs::directory_options::skip_permission_denied;
    for (const fs::directory_entry& entry : fs::directory_iterator(level, skip)) {
      const fs::path name = entry.path().filename();
      if (name != next) fs::create_symlink(entry.path(), tree / level.relative_path() / name);
    }
    level /= next;
    if (!fs::exists(level)) return;
  }
}

/// The default folder in a commit. The files are checked out by git, which also fetches large ones
/// (LFS).
FoundBaseline baseline_of_commit(const std::string& commit, const Manifest& manifest) {
  const fs::path folder = manifest.file.parent_path();
  const CommandResult top = git(folder, {"rev-parse", "--show-toplevel"});
  const fs::path root = first_line(top.output);
  const fs::path path = fs::proximate(fs::weakly_canonical(usual_baseline(manifest)), root);
  FoundBaseline found{.folder = {}, .scratch = std::make_unique<ScratchFolder>()};
  const fs::path tree = found.scratch->path() / "tree";
  link_surroundings(root / path, tree);
  const fs::path files = tree / root.relative_path();
  const auto with_own_index = [&](std::vector<std::string> words) {
    const std::string index = (found.scratch->path() / "index").string();
    words.insert(words.begin(), {"env", "GIT_INDEX_FILE=" + index, "git", "-C", root.string(),
                                 "--work-tree=" + files.string()});
    return run_command(words, git_limit);
  };
  // The whole commit, because .gitattributes define which files are stored in LFS.
  CommandResult end = with_own_index({"read-tree", commit});
  if (end.succeeded())
    end = with_own_index({"checkout", "--force", commit, "--", path.generic_string()});
  if (!end.succeeded())
    throw Error({commit}, "has no baseline: " + first_line(end.errors),
                "commit the folder that mien regress approve wrote, or name another commit");
  found.folder = files / path;
  return found;
}

CommandResult shown_commit(const std::string& name, const Manifest& manifest) {
  return git(manifest.file.parent_path(),
             {"log", "-1", "--format=%H", "--end-of-options", name, "--"});
}

bool is_commit(const std::string& name, const Manifest& manifest) {
  return shown_commit(name, manifest).succeeded();
}

/// Throws Error for a name that is neither a folder nor a commit, with git's message.
[[noreturn]] void throw_unknown(const std::string& name, const Manifest& manifest) {
  const CommandResult end = shown_commit(name, manifest);
  const std::string says = end.is_missing ? "; git is not installed, so commits cannot be looked up"
                                          : "; git says: " + first_line(end.errors);
  const CommandResult shallow =
      git(manifest.file.parent_path(), {"rev-parse", "--is-shallow-repository"});
  throw Error({name}, "there is no folder or commit of that name" + says,
              first_line(shallow.output) == "true"
                  ? "this is a shallow clone: fetch the commit (git fetch origin " + name + ":" +
                        name + "; in GitHub Actions fetch-depth: 0)"
                  : "name a folder, or a branch, tag or commit that git log knows");
}

}  // namespace

fs::path new_baseline(const std::string& given, const Manifest& manifest) {
  if (given.empty()) return usual_baseline(manifest);
  if (!fs::exists(given) && is_commit(given, manifest))
    throw Error(
        {given}, "is a commit, but a baseline is stored in a folder",
        "omit --baseline, and commit the approved folder; for a new folder of that name write ./" +
            given);
  return given;
}

FoundBaseline find_baseline(const std::string& given, const Manifest& manifest) {
  const fs::path folder = given.empty() ? usual_baseline(manifest) : fs::path(given);
  if (is_baseline(folder)) return {folder, nullptr};
  if (!given.empty() && !fs::exists(folder) && is_commit(given, manifest)) {
    FoundBaseline found = baseline_of_commit(given, manifest);
    if (is_baseline(found.folder)) return found;
  }
  if (!given.empty() && !fs::exists(folder)) throw_unknown(given, manifest);
  throw Error({folder.string()}, "holds no baseline",
              "look at the study, and if it is as intended, run mien regress approve " +
                  motion::shell_path(manifest.file.string()) + " --reason \"…\"");
}

}  // namespace mien::pipeline
