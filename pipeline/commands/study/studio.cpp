#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/page_bundle.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/commands/line/external_programs.h"
#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/server/http_server.h"
#include "pipeline/study/studio/open_browser.h"
#include "pipeline/study/studio/studio_service.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// The manifest with which the studio starts if none is named, and the file to which it is saved.
constexpr char first_manifest[] = "quickstart";
constexpr char default_file[] = "studio.yaml";

constexpr std::size_t most_body_bytes = 4 << 20;

struct StudioOptions {
  std::string manifest;
  std::string out = "out";
  int port = 0;
  int jobs = 0;
  bool no_browser = false;
  bool json = false;
  bool walk = false;
};

/// Opens the manifest of that name. An installed one is not modified but saved to a file of its
/// name in the current folder.
std::unique_ptr<ManifestFile> opened(const std::string& name, const Console& console) {
  const Environment environment = process_environment();
  if (!name.empty() && fs::exists(name)) return std::make_unique<ManifestFile>(name, environment);
  const fs::path folder = installed_manifests();
  const auto installed = find_named_file(folder, name.empty() ? first_manifest : name);
  if (!installed) {
    resolve_manifest(name, console);  // throws Error for an unknown name
    throw Error({name}, "there is no such file",
                "name an existing manifest, or omit it for a new one");
  }
  const fs::path own = name.empty() ? fs::path(default_file) : installed->filename();
  if (fs::exists(own)) return std::make_unique<ManifestFile>(own, environment);
  console.err << fmt::format("note: it will be saved to {}\n", own.string());
  return std::make_unique<ManifestFile>(own, environment, read_file(*installed));
}

/// Warnings of the opened manifest, which the page has no place for.
std::vector<Fault> warnings_of(const ManifestFile& file) {
  return parse_manifest(file.state().text, file.file(), file.environment()).manifest.renamed;
}

/// Adds the walker's page to the studio's, with the motion module that runs in the browser.
void add_walker(std::map<std::string, ServedFile>& page) {
  std::string module = read_file(live_module());
  for (auto& [name, file] : served_page(page_bundle("walk")))
    page[name == "index.html" ? walker_page : name] = std::move(file);
  page[walker_page].webassembly = true;
  page["live_core.wasm"] = {.bytes = std::move(module), .type = "application/wasm"};
}

/// Whether all files of the walker exist.
bool has_walker() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return !live_module_beside(program).empty() && !page_beside(program, "walk").empty();
}

fs::path folder_for(const StudioOptions& options, const ManifestFile& file) {
  const nlohmann::ordered_json document = file.state().document;
  return fs::path(options.out) / (document.at("study").get<std::string>() + ".studio");
}

void print_link(const StudioOptions& options, const std::string& link, const ManifestFile& file,
                const Console& console) {
  if (options.json) {
    const nlohmann::ordered_json link_json = {{"link", link}, {"manifest", file.file().string()}};
    console.out << link_json.dump() << std::endl;
    return;
  }
  console.out << fmt::format("{} in the studio: {}\nStop with Ctrl-C.\n", file.file().string(),
                             link);
  console.out.flush();
}

void wait_for_stop(const std::stop_token& stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait(lock, stop, [] { return false; });
}

int run_studio(const StudioOptions& options, const Console& console) {
  auto page = served_page(page_bundle("studio"));
  if (options.walk || has_walker()) add_walker(page);
  const std::unique_ptr<ManifestFile> file = opened(options.manifest, console);
  print_warnings(warnings_of(*file), console);
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = options.jobs > 0 ? options.jobs : std::max(1, processors);
  StudioService service(*file, std::move(page), folder_for(options, *file), threads);
  HttpSettings settings{.listen = "127.0.0.1", .port = options.port};
  settings.limits.body_bytes = most_body_bytes;
  std::mutex telling;
  const HttpServer server(
      settings, [&](const HttpRequest& request) { return service.answer(request); },
      [&](const std::string& failure) {
        const std::lock_guard lock(telling);
        console.err << "mien: " << failure << std::endl;
      });
  service.set_port(server.port());
  const std::string link = fmt::format("http://127.0.0.1:{}/{}/{}", server.port(), service.link(),
                                       options.walk ? walker_page : "");
  print_link(options, link, *file, console);
  std::optional<OpenedBrowser> browser;
  if (!options.no_browser && !options.json) browser.emplace(link);
  wait_for_stop(console.stop);
  return exit_done;
}

}  // namespace

Command studio_command() {
  const auto options = std::make_shared<StudioOptions>();
  return {.name = studio_program.command,
          .summary = studio_program.summary,
          .options = {argument("manifest", &options->manifest,
                               "Manifest (YAML) to open, or the name of an installed manifest "
                               "(listed by mien manifests); default: studio.yaml in the current "
                               "folder")
                          .optional(),
                      option("--out", &options->out, "Folder of all studies").with_default(),
                      option("--port", &options->port, "Port to listen on; 0: any free port")
                          .between(0, 65535)
                          .with_default(),
                      option("--jobs,-j", &options->jobs,
                             "Number of threads for stills and videos (default: one per processor)")
                          .between(1, 1024),
                      flag("--walk", &options->walk,
                           "Open a walker steered by arrow keys or a gamepad, with sliders for "
                           "moods; compiled on first use; after that, the studio has a link to it"),
                      flag("--no-browser", &options->no_browser,
                           "Print the link instead of opening a browser"),
                      flag("--json", &options->json,
                           "Print the link as JSON instead of opening a browser")},
          .notes =
              "Opens a page that shows the manifest's stimuli and updates them as they are edited. "
              "It is accessible\n"
              "only from this machine, by a link that is new each time. Saving changes only the "
              "edited lines of the\n"
              "manifest; comments are kept. Stills and videos from the renderer are saved to\n"
              "<out>/<study>.studio.\n\n"
              "Examples:\n"
              "  mien studio my.yaml\n"
              "  mien studio --walk\n"
              "  mien studio quickstart --no-browser",
          .run = [options](const Console& console) { return run_studio(*options, console); }};
}

}  // namespace mien::pipeline
