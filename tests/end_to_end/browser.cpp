#include "end_to_end/browser.h"

#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {

namespace {

/// What it ends with is in the page's own text, in hexadecimal, for no markup to come between.
std::string script_of(const std::string& body) {
  return R"(<script>
(async () => {
  const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));
  const press = async (key, shiftKey = false) => {
    (document.activeElement ?? document.body).dispatchEvent(
      new KeyboardEvent("keydown", {key, shiftKey, bubbles: true, cancelable: true}));
    await wait(60);
  };
  const errors = [];
  addEventListener("error", event => errors.push(event.message));
  let outcome = {};
  try {
    await wait(300);
    outcome = await (async () => {)" +
         body + R"(})();
  } catch (error) { errors.push(String(error)); }
  if (errors.length) outcome = {error: errors.join("; ")};
  const bytes = new TextEncoder().encode(JSON.stringify(outcome));
  document.body.dataset.outcome = Array.from(bytes, byte => byte.toString(16).padStart(2, "0")).join("");
})();
</script>
)";
}

std::string from_hexadecimal(const std::string& digits) {
  std::string text;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    text += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return text;
}

}  // namespace

std::string chromium() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    if (run_program({name, "--version"}).code == 0) return name;
  }
  return "";
}

nlohmann::json in_browser(const std::filesystem::path& page, const std::string& body) {
  const Scratch profile;
  const std::filesystem::path driven = page.parent_path() / "driven.html";
  std::filesystem::remove(driven);
  const Scratch scratch;
  std::filesystem::copy_file(scratch.write("driven.html", text_of(page) + script_of(body)), driven);
  const Ended ended = run_program(
      {chromium(), "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1280,900",
       "--host-resolver-rules=MAP * ~NOTFOUND", "--virtual-time-budget=60000",
       "--user-data-dir=" + profile.path().string(), "--dump-dom", "file://" + driven.string()},
      120.0);
  std::filesystem::remove(driven);
  const std::string start = "data-outcome=\"";
  const std::size_t at = ended.output.find(start);
  if (at == std::string::npos) return {{"error", "no outcome; " + ended.errors}};
  const std::size_t from = at + start.size();
  return nlohmann::json::parse(
      from_hexadecimal(ended.output.substr(from, ended.output.find('"', from) - from)));
}

}  // namespace mien::test
