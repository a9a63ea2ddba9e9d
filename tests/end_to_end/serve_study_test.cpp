#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/study/server/raw_client.h"

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using pipeline::body_in;
using pipeline::get_request;
using pipeline::post_request;
using pipeline::reply_of;
using pipeline::status_in;

constexpr char served_text[] = R"(mien: 1
study: gaits
seed: 7
examples: {set: builtin:walks-10}
output: {size: [96, 72], fps: 15, cycles: 1, quality: draft, video: [mp4], frames: none}
stimuli:
  - {id: usual, weights: {normal: 1}}
  - {id: sad, weights: {normal: 0.4, sad: 0.6}}
questionnaire:
  title: How does this person walk?
  participants: 2
  consent: Taking part is voluntary.
  scales: emotions
  attention: {every: 1}
  demographics:
    - {id: age, ask: "How old are you?", answer: number, required: true}
)";

/// What lies beside the program.
fs::path program_part(const std::string& name) {
  return fs::path(MIEN_PROGRAM).parent_path() / name;
}

/// A mien with pages beside it that stand for those that Node.js builds.
fs::path mien_with_pages(const fs::path& folder) {
  const fs::path program = folder / "mien";
  for (const std::string name : {"lab", "questionnaire"}) {
    const fs::path page = folder / "pages" / name;
    fs::create_directories(page);
    std::ofstream(page / "index.html")
        << "<!doctype html><meta name=\"mien-mode\" content=\"static\"><title>" << name
        << "</title>";
    std::ofstream(page / (name + ".js")) << "start();";
  }
  for (const fs::path& part :
       {fs::path(MIEN_PROGRAM), program_part("mien-study"), program_part("mien-image-files.so"),
        program_part("mien-pages.so"), program_part("mien-video-files.so")}) {
    std::error_code other_disk;
    fs::create_hard_link(part, folder / part.filename(), other_disk);
    if (other_disk) fs::copy_file(part, folder / part.filename());
  }
  return program;
}

/// A served study, the links of which are in `links`.
class ServedStudy : public testing::Test {
 protected:
  std::vector<std::string> command(const std::string& study) const {
    return {program.string(),
            "study",
            "serve",
            study,
            "--out",
            (folder.path() / "out").string(),
            "--port",
            "0",
            "--json",
            "--store",
            (folder.path() / "kept.db").string()};
  }

  /// Waits for a server that has just been started; by participant, where the page is.
  void read_links() {
    const fs::path file = folder.path() / "kept-links.csv";
    links.clear();
    for (int tries = 0; tries < 3000 && links.size() < 2; ++tries) {
      pause_for(0.1);
      std::ifstream lines(file);
      for (std::string line; std::getline(lines, line);) {
        if (line.find("http://") != line.npos) add_link(line);
      }
    }
    ASSERT_EQ(links.size(), 2u);
  }

  void add_link(const std::string& line) {
    const std::size_t comma = line.find(',');
    const std::size_t colon = line.rfind(':');
    const std::size_t slash = line.find('/', colon);
    port = std::stoi(line.substr(colon + 1, slash - colon - 1));
    links[line.substr(0, comma)] = line.substr(slash);
  }

  std::string get(const std::string& target, const std::string& headers = "") const {
    return reply_of(port, get_request(target, headers));
  }

  int give(const std::string& page, json record) const {
    record["session"] = "browser";
    const std::string name = record.at("record");
    return status_in(reply_of(port, post_request(page + "records/" + name, record.dump())));
  }

  static json record_of(const json& trial) {
    json responses = json::array();
    for (const json& item : trial.at("items"))
      responses.push_back({{"item", item.at("item")}, {"value_raw", 1}, {"rt_ms", 800}});
    return {{"record", "trial-" + std::to_string(trial.at("number").get<int>())},
            {"responses", std::move(responses)}};
  }

  void take_part(const std::string& page) const {
    const json session = json::parse(body_in(get(page + "session.json")));
    const json agreed = {{{"item", "consent"}, {"value_raw", "agreed"}}};
    ASSERT_EQ(give(page, {{"record", "consent"}, {"responses", agreed}}), 200);
    const json age = {{{"item", "age"}, {"value_raw", 30}}};
    ASSERT_EQ(give(page, {{"record", "demographics"}, {"responses", age}}), 200);
    for (const json& trial : session.at("sessions").at(0).at("trials"))
      ASSERT_EQ(give(page, record_of(trial)), 200) << trial.dump();
    ASSERT_EQ(give(page, {{"record", "ending"}, {"responses", json::array()}}), 200);
  }

  const Scratch folder;
  const fs::path program = mien_with_pages(folder.path() / "bin");
  const std::string manifest = folder.write("gaits.yaml", served_text).string();
  std::map<std::string, std::string> links;
  int port = 0;
};

TEST_F(ServedStudy, IsTakenGoesOnAfterBeingKilledAndEndsWhenTold) {
  Running first(command(manifest));
  read_links();
  const std::string page = links.at("p001");
  EXPECT_NE(body_in(get(page)).find("content=\"served\""), std::string::npos);
  const json session = json::parse(body_in(get(page + "session.json")));
  ASSERT_EQ(session.at("sessions").size(), 1u);
  for (const auto& [token, media] : session.at("media").items()) {
    const std::string part = get("/media/" + token, "Range: bytes=4-7\r\n");
    EXPECT_EQ(status_in(part), 206);
    EXPECT_EQ(body_in(part), "ftyp");  // of an MP4
  }
  take_part(page);

  const Ended second = run_program(command(manifest));
  EXPECT_EQ(second.code, 2);
  EXPECT_NE(second.errors.find("another process has it open"), std::string::npos) << second.errors;

  first.send(SIGKILL);
  const json places = json::parse(first.wait().output);
  const std::map<std::string, std::string> before = links;
  fs::remove(folder.path() / "kept-links.csv");
  Running again(command(manifest));
  read_links();
  EXPECT_EQ(links, before);
  const json kept = json::parse(body_in(get(page + "session.json"))).at("kept");
  EXPECT_EQ(kept.back(), "ending");
  const std::string lab = places.at("lab");
  const std::string place = lab.substr(lab.find("/lab/"));
  EXPECT_NE(body_in(get(place)).find("<title>lab</title>"), std::string::npos);
  EXPECT_EQ(status_in(get(place + "lab.js")), 200);
  EXPECT_EQ(status_in(get(place + "questionnaire.js")), 404);
  const std::string csv = body_in(get(place + "answers.csv"));
  EXPECT_EQ(csv.find("participant,session,trial,"), 0u);
  EXPECT_NE(csv.find("\np001,browser,"), std::string::npos);
  again.send(SIGINT);
  const Ended ended = again.wait(60);
  EXPECT_EQ(ended.code, 0) << ended.errors;
  EXPECT_NE(ended.errors.find("1 of 2 participants"), std::string::npos) << ended.errors;

  std::string other = served_text;
  other.replace(other.find("voluntary"), 9, "welcome");
  fs::remove_all(folder.path() / "out");
  const Ended changed = run_program(command(folder.write("gaits.yaml", other).string()));
  EXPECT_EQ(changed.code, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "out")) << "was made before it was refused";
  EXPECT_NE(changed.errors.find("was started with a different questionnaire"), std::string::npos)
      << changed.errors;
}

TEST_F(ServedStudy, IsRefusedWhereItCannotBeServed) {
  std::vector<std::string> words = command(manifest);
  words.insert(words.end(), {"--url", "elsewhere"});
  const Ended no_url = run_program(words);
  EXPECT_EQ(no_url.code, 2);
  EXPECT_NE(no_url.errors.find("is not the address of a web server"), std::string::npos);
  fs::remove_all(folder.path() / "bin/pages");
  const Ended no_pages = run_program(command(manifest));
  EXPECT_EQ(no_pages.code, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "kept.db"));
}

}  // namespace
}  // namespace mien::test
