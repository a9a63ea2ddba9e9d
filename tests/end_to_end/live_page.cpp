#include "end_to_end/live_page.h"

#include "end_to_end/browser.h"

namespace mien::test {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path pages() { return fs::path(MIEN_PROGRAM).parent_path() / "pages"; }

std::string skip_reason() {
  if (chromium().empty()) return "no Chromium here: install it to test pages";
  if (run_program({"node", "--version"}).code != 0) return "no Node.js here";
  if (!fs::exists(pages() / "work/node_modules/playwright-core"))
    return "no playwright-core in build/release/pages/work: ./mien test brings it";
  return "";
}

}  // namespace

void LivePage::SetUp() {
  if (const std::string why = skip_reason(); !why.empty()) GTEST_SKIP() << why;
  scratch.write("study.yaml", manifest_);
}

bool LivePage::is_exported() const {
  if (!fs::exists(pages() / "live_core/live_core.wasm")) return false;
  const Ended ended =
      run_mien({"study", "export", study().string(), "-o", folder().string()}, 60.0);
  EXPECT_EQ(ended.code, 0) << ended.errors;
  return true;
}

Running LivePage::serve() const { return Running(serve_words("0")); }

std::unique_ptr<Running> LivePage::serving(const std::string& port) const {
  return std::make_unique<Running>(serve_words(port));
}

std::vector<std::string> LivePage::serve_words(const std::string& port) const {
  return {MIEN_PROGRAM, "study",  "serve",   study().string(), "--port",
          port,         "--json", "--store", store().string()};
}

std::string LivePage::link_of(int participant) const {
  fs::path links = store();
  links.replace_filename(store().stem().string() + "-links.csv");
  for (int tries = 0; tries < 600; ++tries) {
    pause_for(0.1);
    if (!fs::exists(links)) continue;
    const std::string text = text_of(links);
    std::size_t begin = text.find("http://");
    for (int i = 0; i < participant && begin != text.npos; ++i)
      begin = text.find("http://", begin + 1);
    if (begin != text.npos) return text.substr(begin, text.find('\n', begin) - begin);
  }
  ADD_FAILURE() << "no link in " << links;
  return "";
}

std::vector<std::string> LivePage::script_words(const std::string& script,
                                                const std::vector<std::string>& arguments) const {
  const std::string said = run_program({"sh", "-c", "command -v " + chromium()}).output;
  std::vector<std::string> command = {"env", "MIEN_CHROMIUM=" + said.substr(0, said.find('\n')),
                                      "node"};
  if (arguments.empty()) command.emplace_back("--test");
  command.push_back((pages() / "work/tests" / kind_ / script).string());
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

Ended LivePage::run_script(const std::string& script,
                           const std::vector<std::string>& arguments) const {
  return run_program(script_words(script, arguments), 500.0);
}

json LivePage::played(const std::string& scenario, const std::string& where) const {
  const Ended ended = run_script("scenarios.mjs", {scenario, where});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  const json told = json::parse(ended.output, nullptr, false);
  if (told.contains("troubles")) {
    EXPECT_EQ(told.at("troubles"), json::array());
  }
  return told;
}

}  // namespace mien::test
