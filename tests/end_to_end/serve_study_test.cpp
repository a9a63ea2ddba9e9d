#include <algorithm>
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
using pipeline::free_port;
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
  EXPECT_NE(ended.errors.find("1 of 1 participant who began has finished"), std::string::npos)
      << ended.errors;

  std::string other = served_text;
  other.replace(other.find("voluntary"), 9, "welcome");
  fs::remove_all(folder.path() / "out");
  const Ended changed = run_program(command(folder.write("gaits.yaml", other).string()));
  EXPECT_EQ(changed.code, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "out")) << "was made before it was refused";
  EXPECT_NE(changed.errors.find("was started with a different questionnaire"), std::string::npos)
      << changed.errors;
}

TEST_F(ServedStudy, IsLeftByWhoWithdrawsAfterwards) {
  Running server(command(manifest));
  read_links();
  take_part(links.at("p001"));
  take_part(links.at("p002"));
  server.send(SIGINT);
  const json places = json::parse(server.wait(60).output);
  fs::create_directories(folder.path() / "exported");
  const std::string table = "participant,session,value\np001,browser,1\np002,other,2\n";
  folder.write("exported/answers.csv", table);
  folder.write("exported/notes.csv", "about,p001\n");
  const auto withdraw = [&](const std::string& who) {
    return run_program({program.string(), "study", "withdraw", who,
                        (folder.path() / "kept.db").string(),
                        (folder.path() / "exported").string()});
  };
  // Marked as of the first version, which only serving converts.
  const std::string answers = text_of(folder.path() / "kept.db");
  std::string former = answers;
  ASSERT_EQ(former.at(63), 2);
  former[63] = 1;
  folder.write("kept.db", former);
  const Ended nobody = withdraw("p009");
  EXPECT_EQ(text_of(folder.path() / "kept.db"), former);
  folder.write("kept.db", answers);
  EXPECT_EQ(nobody.code, 2);
  EXPECT_NE(nobody.errors.find("is in none of these files"), std::string::npos) << nobody.errors;
  EXPECT_EQ(text_of(folder.path() / "exported/answers.csv"), table);
  const std::string shared = "participant,session,value\np005,aa,1\np005,bb,2\n";
  folder.write("exported/more.csv", shared);
  const Ended several = withdraw("p005");
  EXPECT_EQ(several.code, 2);
  EXPECT_NE(several.errors.find("2 browser sessions"), std::string::npos) << several.errors;
  EXPECT_EQ(text_of(folder.path() / "exported/more.csv"), shared);
  EXPECT_EQ(withdraw("bb").code, 0);
  EXPECT_EQ(text_of(folder.path() / "exported/more.csv"), "participant,session,value\np005,aa,1\n");
  folder.write("exported/broken.csv", "participant,session\n\"p001,browser\n");
  folder.write("exported/foreign.csv", "a\n\xff\n");
  const Ended broken = withdraw("p001");
  EXPECT_EQ(broken.code, 2);
  for (const char* words : {"broken.csv", "foreign.csv", "nothing was deleted"})
    EXPECT_NE(broken.errors.find(words), std::string::npos) << broken.errors;
  EXPECT_EQ(text_of(folder.path() / "exported/answers.csv"), table);
  for (const char* name : {"broken.csv", "foreign.csv"})
    fs::remove(folder.path() / "exported" / name);
  fs::create_directory(folder.path() / "exported/results");
  folder.write("exported/results/sessions.csv", "participant,trials\np001,6\n");
  folder.write("exported/report.html", "p001");
  const Ended done = withdraw("p001");
  EXPECT_EQ(done.code, 1) << done.errors;
  EXPECT_NE(done.errors.find("report.html: was made from these tables"), std::string::npos)
      << done.errors;
  EXPECT_NE(done.errors.find("sessions.csv: names p001 and was not changed"), std::string::npos)
      << done.errors;
  EXPECT_NE(done.output.find("answers.csv: rows deleted: 1"), std::string::npos) << done.output;
  EXPECT_NE(done.output.find("; the session is counted as withdrawn"), std::string::npos);
  EXPECT_EQ(text_of(folder.path() / "exported/answers.csv"),
            "participant,session,value\np002,other,2\n");
  EXPECT_EQ(text_of(folder.path() / "exported/notes.csv"), "about,p001\n");
  const Ended again = withdraw("p001");
  EXPECT_EQ(again.code, 2) << again.output;
  fs::remove(folder.path() / "kept-links.csv");  // of the server before, on another port
  Running anew(command(manifest));
  read_links();
  const json session = json::parse(body_in(get(links.at("p001") + "session.json")));
  EXPECT_EQ(session.at("ended"), "withdrawn");
  EXPECT_EQ(session.at("kept"), json::array());
}

/// What the page of the manual tells people to copy, with other ports, names and files.
std::string nginx_site(const fs::path& folder, int https, int http, int served) {
  std::string site =
      text_of(fs::path(MIEN_SOURCE_DIR) / "pipeline/study/questionnaire/mien.nginx.conf");
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = site.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    site.replace(at, from.size(), to);
  };
  replace("listen 443 ssl", "listen 127.0.0.1:" + std::to_string(https) + " ssl");
  replace("listen 80", "listen 127.0.0.1:" + std::to_string(http));
  replace("/etc/letsencrypt/live/lab.example.org/fullchain.pem", (folder / "own.pem").string());
  replace("/etc/letsencrypt/live/lab.example.org/privkey.pem", (folder / "own.key").string());
  replace("/var/log/nginx/error.log", (folder / "error.log").string());
  replace("127.0.0.1:8080", "127.0.0.1:" + std::to_string(served));
  std::string places;
  for (const char* what : {"client_body", "proxy", "fastcgi", "uwsgi", "scgi"})
    places += std::string(what) + "_temp_path " + (folder / what).string() + ";\n";
  return "daemon off;\npid " + (folder / "nginx.pid").string() + ";\nevents {}\nhttp {\n" + places +
         site + "}\n";
}

TEST_F(ServedStudy, IsServedWithTlsByNginx) {
  for (const char* needed : {"nginx", "curl", "openssl"})
    if (run_program({"sh", "-c", std::string("command -v ") + needed}).code != 0)
      GTEST_SKIP() << "no " << needed << " here";
  std::vector<std::string> words = command(manifest);
  words.insert(words.end(), {"--behind-proxy", "--url", "https://lab.example.org"});
  const int served = free_port();
  *std::ranges::find(words, "0") = std::to_string(served);
  const fs::path told = folder.path() / "told.json";
  words.insert(words.begin(), {"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", told});
  const Running server(words);
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(told), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  must_run({"openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj",
            "/CN=lab.example.org", "-keyout", (folder.path() / "own.key").string(), "-out",
            (folder.path() / "own.pem").string()});
  const int https = free_port(), http = free_port();
  const fs::path site = folder.write("nginx.conf", nginx_site(folder.path(), https, http, served));
  const Running nginx({"nginx", "-c", site.string(), "-e", (folder.path() / "error.log").string()});
  const std::string secure = "https://lab.example.org:" + std::to_string(https);
  const auto asked = [&](std::vector<std::string> more) {
    std::vector<std::string> all = {"curl",
                                    "--silent",
                                    "--show-error",
                                    "--include",
                                    "--retry",
                                    "50",
                                    "--retry-connrefused",
                                    "--retry-delay",
                                    "1",
                                    "--cacert",
                                    (folder.path() / "own.pem").string(),
                                    "--resolve",
                                    "lab.example.org:" + std::to_string(https) + ":127.0.0.1"};
    all.insert(all.end(), more.begin(), more.end());
    return must_run(all);
  };
  const std::string join = places.at("join");
  ASSERT_TRUE(join.starts_with("https://lab.example.org/join/"));
  const std::string page = secure + join.substr(join.find("/join/"));
  EXPECT_EQ(status_in(asked({page})), 200);
  const std::string agreed = asked(
      {"-H", "Content-Type: application/json", "-d",
       R"({"record": "consent", "session": "b1", "responses": [{"item": "consent", "value_raw": "agreed"}]})",
       page + "records/consent"});
  EXPECT_EQ(status_in(agreed), 200) << agreed;
  const std::string lab = places.at("lab");
  const std::string exports = secure + lab.substr(lab.find("/lab/"));
  const std::string links_table = asked({exports + "links.csv"});
  EXPECT_NE(links_table.find("p001,https://lab.example.org"), std::string::npos) << links_table;
  EXPECT_NE(asked({exports + "participants.csv"}).find("\np003,b1,"), std::string::npos);
  const json session = json::parse(body_in(asked(
      {secure + "/s/" + links_table.substr(links_table.find("/s/") + 3, 32) + "/session.json"})));
  const std::string token = session.at("media").begin().key();
  const std::string part = asked({"-r", "4-7", secure + "/media/" + token});
  EXPECT_EQ(status_in(part), 206);
  EXPECT_EQ(body_in(part), "ftyp");
  const std::string plain =
      must_run({"curl", "--silent", "--include", "-H", "Host: lab.example.org",
                "http://127.0.0.1:" + std::to_string(http) + "/join/x/"});
  EXPECT_EQ(status_in(plain), 301);
  EXPECT_NE(plain.find("Location: https://lab.example.org/join/x/"), std::string::npos) << plain;
  EXPECT_EQ(text_of(folder.path() / "error.log"), "");
}

TEST_F(ServedStudy, IsRefusedWhereItCannotBeServed) {
  std::vector<std::string> words = command(manifest);
  words.insert(words.end(), {"--url", "elsewhere"});
  const Ended no_url = run_program(words);
  EXPECT_EQ(no_url.code, 2);
  EXPECT_NE(no_url.errors.find("is not the address of a web server"), std::string::npos);
  words = command(manifest);
  words.back() = (folder.path() / "none/kept.db").string();
  const Ended no_folder = run_program(words);
  EXPECT_EQ(no_folder.code, 2);
  EXPECT_NE(no_folder.errors.find("there is no folder for it"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder.path() / "out"));  // nothing was rendered
  fs::remove_all(folder.path() / "bin/pages");
  const Ended no_pages = run_program(command(manifest));
  EXPECT_EQ(no_pages.code, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "kept.db"));
}

}  // namespace
}  // namespace mien::test
