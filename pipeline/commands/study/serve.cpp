#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/page_bundle.h"
#include "pipeline/commands/study/matching_design.h"
#include "pipeline/commands/study/prepared_questionnaire.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/chains/experiment/chain_study.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/page/served_page.h"
#include "pipeline/study/questionnaire/experiment/restricted_motions.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/server/http_server.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct ServeOptions {
  ProductionArguments study;
  std::string listen = "127.0.0.1";
  int port = 8080;
  std::string store;  ///< empty: <out>/<study>-answers.db
  std::string url;    ///< empty: http://<listen>:<port>
  bool behind_proxy = false;
  bool json = false;
};

/// The files of answers and of links.
struct ServedFiles {
  fs::path answers;
  fs::path links;
};

ServedFiles served_files(const ServeOptions& options, const Manifest& manifest) {
  const fs::path out = options.study.out;
  if (options.store.empty())
    return {out / (manifest.study + "-answers.db"), out / (manifest.study + "-links.csv")};
  fs::path links = options.store;
  links.replace_filename(links.stem().string() + "-links.csv");
  return {options.store, links};
}

/// The server's URL for participants. Throws Error for an invalid address.
std::string base_url(const ServeOptions& options, int port) {
  if (!options.url.empty()) {
    const bool is_web = options.url.starts_with("http://") || options.url.starts_with("https://");
    if (!is_web || options.url.find_first_of(" \"<>\r\n") != std::string::npos)
      throw Error({"--url"}, motion::in_quotes(options.url) + " is not the address of a web server",
                  "write it like https://lab.example.org");
    return options.url.substr(0, options.url.find_last_not_of('/') + 1);
  }
  const bool is_v6 = options.listen.find(':') != std::string::npos;
  return fmt::format("http://{}:{}", is_v6 ? "[" + options.listen + "]" : options.listen, port);
}

bool is_loopback(const std::string& address) {
  return address.starts_with("127.") || address == "::1" || address == "localhost";
}

/// Writes the links to a file readable only by its owner, the experimenter.
void write_links(const fs::path& file, const std::string& text) {
  write_file(file, "");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_file(file, text);
}

void print_links(const ServeOptions& options, const ServedFiles& files, const std::string& base,
                 const StudySessions& sessions, const Console& console) {
  const std::string lab = base + "/lab/" + sessions.lab_link() + "/";
  const std::string join = base + "/join/" + sessions.join_link() + "/";
  if (options.json) {
    const nlohmann::ordered_json places = {{"lab", lab},
                                           {"join", join},
                                           {"links", files.links.string()},
                                           {"answers", files.answers.string()}};
    console.out << places.dump() << std::endl;
    return;
  }
  console.out << fmt::format(
      "experimenter     {}\n"
      "open link        {}\n"
      "personal links   {}\n"
      "answers          {}\n"
      "Stop with Ctrl-C. Answers are kept, and the same command continues from there.\n",
      lab, join, files.links.string(), files.answers.string());
  if (!is_loopback(options.listen) && !options.behind_proxy)
    console.out << "Answers are sent unencrypted: use a trusted network, or a web server with TLS "
                   "in front of this one (--url).\n";
  console.out.flush();
}

/// Prints failures of the running server; a repeated one is printed once.
class FailureReporter {
 public:
  explicit FailureReporter(const Console& console) : console_(console) {}

  void report(const std::string& last_failure) {
    const std::lock_guard lock(mutex_);
    if (last_failure == last_) return;
    last_ = last_failure;
    if (!last_failure.empty()) console_.err << "mien: " << last_failure << std::endl;
  }

  void wait(const QuestionnaireService& service) {
    while (!console_.stop.stop_requested()) {
      report(service.last_failure());
      std::unique_lock lock(wait_mutex_);
      std::condition_variable_any().wait_for(lock, console_.stop, std::chrono::seconds(1),
                                             [] { return false; });
    }
  }

 private:
  const Console& console_;
  std::mutex mutex_, wait_mutex_;
  std::string last_;
};

/// The existing store of this questionnaire, if any. Throws Error if it belongs to another one,
/// which StudySessions would only detect after the study has been run.
std::unique_ptr<SessionStore> store_so_far(const fs::path& file, const Manifest& manifest) {
  if (!fs::exists(file)) return nullptr;
  auto store = std::make_unique<SessionStore>(file);
  const std::optional<std::string> name = store->fact("study"), design = store->fact("design");
  if (name && *name != manifest.study)
    throw Error({file.string()},
                fmt::format("holds answers of the study {}", motion::in_quotes(*name)),
                "name another file with --store");
  if (design && *design != design_hash(manifest, plan_sessions(manifest)))
    throw Error({file.string()},
                "was started with a different questionnaire: texts, plans or participants have "
                "changed since",
                "serve the unchanged study, or start again with another file (--store); mien study "
                "report accepts several files of answers");
  return store;
}

/// Settings of the server, with higher limits for matching: sliders request a motion with every
/// step and a trial records all of them.
HttpSettings settings_of(const ServeOptions& options, const ServedStudy& study) {
  HttpSettings settings{
      .listen = options.listen, .port = options.port, .behind_proxy = options.behind_proxy};
  if (study.live) {
    settings.requests = {.burst = 20000, .per_second = 2000};
    settings.limits.body_bytes = std::size_t{4} << 20U;
  }
  return settings;
}

/// Serves the study until stopped. Returns the exit code.
int serve_study(ServedStudy& study, SessionStore& store, const ServeOptions& options,
                const ServedFiles& files, const Console& console) {
  if (!options.url.empty()) study.public_url = base_url(options, options.port);
  QuestionnaireService service(study, store);
  FailureReporter failures(console);
  {
    const HttpServer server(
        settings_of(options, study),
        [&](const HttpRequest& request) { return service.answer(request); },
        [&](const std::string& failure) { failures.report(failure); });
    const std::string base = base_url(options, server.port());
    write_links(files.links, links_csv(service.sessions(), base));
    print_links(options, files, base, service.sessions(), console);
    failures.wait(service);
  }
  // Sessions of links that nobody has opened are no participants.
  std::size_t begun = 0;
  std::size_t finished = 0;
  for (const SessionState& state : service.sessions().states()) {
    begun += state.stored > 0 ? 1 : 0;
    finished += state.has_finished() ? 1 : 0;
  }
  console.err << fmt::format("{} of {} who began {} finished; {} stored\n", finished,
                             counted_noun(begun, "participant", "participants"),
                             finished == 1 ? "has" : "have",
                             counted_noun(store.records().size(), "record", "records"));
  return exit_done;
}

ServedStudy live_study(const Manifest& manifest, const Console& console) {
  Motions motions(manifest);
  if (manifest.adaptive)
    return served_chains(chain_study(manifest, motions), page_bundle("chains"));
  MatchingStudy made = matching_study(manifest, motions);
  warn_of_matched_at_start(manifest, made, console);
  return served_matching(std::move(made), page_bundle("matching"));
}

/// Serves an experiment whose motions are synthesized while it runs.
int serve_live(const Manifest& manifest, const ServeOptions& options, const Console& console) {
  const ServedFiles files = served_files(options, manifest);
  ServedStudy study = live_study(manifest, console);
  study.lab = served_page(page_bundle("lab"));
  make_folder(files.answers.parent_path());
  SessionStore store(files.answers);
  return serve_study(study, store, options, files, console);
}

/// Throws Error if the port is in use.
void refuse_taken_port(const ServeOptions& options) {
  if (options.port == 0) return;
  const HttpServer there({.listen = options.listen, .port = options.port},
                         [](const HttpRequest&) { return HttpResponse{}; });
}

int serve(const ServeOptions& options, const Console& console) {
  // Errors that would stop the server later are reported before anything is drawn.
  base_url(options, options.port);
  refuse_taken_port(options);
  const Manifest asked = participants_manifest(options.study.manifest, console);
  for (const Fault& fault : restricted_motions(asked))
    console.err << "warning: " << to_string(fault) << '\n';
  if (asked.matching || asked.adaptive) return serve_live(asked, options, console);
  const fs::path pages = page_bundle("questionnaire");
  const ServedFiles files = served_files(options, asked);
  if (!options.store.empty() && !fs::is_directory(fs::absolute(files.answers).parent_path()))
    throw Error({options.store}, "there is no folder for it", "create the folder first");
  std::unique_ptr<SessionStore> opened = store_so_far(files.answers, asked);
  const PreparedQuestionnaire made = prepared_questionnaire(options.study, console);
  ServedStudy study = served_study(made.manifest, made.plans, made.media, pages);
  study.lab = served_page(page_bundle("lab"));
  if (!opened) opened = std::make_unique<SessionStore>(files.answers);
  return serve_study(study, *opened, options, files, console);
}

}  // namespace

Command study_serve_command() {
  const auto options = std::make_shared<ServeOptions>();
  return {
      .name = "serve",
      .summary = "Serve the questionnaire or experiment from this machine, for use in a laboratory",
      .options = all_of(
          questionnaire_options(options->study),
          option("--port", &options->port, "Port to listen on; 0: any free port")
              .between(0, 65535)
              .with_default(),
          option("--listen", &options->listen,
                 "Address to listen on; 0.0.0.0 for all addresses of this machine")
              .with_default(),
          option("--store", &options->store,
                 "File in which answers are stored (default: <out>/<study>-answers.db)"),
          option("--url", &options->url,
                 "URL at which participants reach this server, if not its address and port"),
          flag("--behind-proxy", &options->behind_proxy,
               "A web server with TLS forwards all requests and states the clients' addresses "
               "(X-Forwarded-For)"),
          flag("--json", &options->json, "Print the links as JSON")),
      .notes =
          "First makes the videos that a questionnaire shows, as mien run does. Each planned "
          "participant has a\n"
          "personal link, and an open link admits anybody else. Each page is stored on disk "
          "before the next is shown.\n"
          "The experimenter's page shows the progress of all participants and exports the "
          "answers as CSV. Other\n"
          "machines have access only with --listen.\n\n"
          "Examples:\n"
          "  mien study serve study.yaml\n"
          "  mien study serve study.yaml --listen 0.0.0.0 --port 8000 --store monday.db\n"
          "  mien study serve study.yaml --behind-proxy --url https://lab.example.org",
      .run = [options](const Console& console) { return serve(*options, console); }};
}

}  // namespace mien::pipeline
