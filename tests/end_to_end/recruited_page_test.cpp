#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST_F(QuestionnairePage, TakesThoseWhomProlificSendsAndSendsThemBack) {
  std::string text = study_text;
  text += R"(
  consent_version: "2.1"
  debriefing: We wanted to know whether the mood of a walk can be seen.
  screening:
    window: [1000, 600]
    questions:
      - {id: years, ask: "How old are you, in years?", answer: number, accept: {from: 18, to: 99}}
      - {id: vision, ask: "Do you see well?", answer: ["yes", "no"], accept: "yes"}
  analysis: {max_failed_checks: 0}
  recruitment:
    prolific: {completed: CDONE, refused: CREFUSED, withdrawn: CLEFT}
    redirect:
      screened_out: "https://app.prolific.com/out?pid={PROLIFIC_PID}"
      failed_attention: "https://app.prolific.com/failed?study={STUDY_ID}"
)";
  const fs::path manifest = scratch->write("recruited.yaml", text);
  const fs::path told = scratch->path() / "recruiting.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", told.string(),
                        MIEN_PROGRAM, "study", "serve", manifest.string(), "--out",
                        (scratch->path() / "out").string(), "--port", "0", "--json", "--store",
                        (scratch->path() / "recruited.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(told), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const json run = played(
      "prolific", scratch->write("recruited.json", json{{"join", places.at("join")}}.dump()));
  EXPECT_EQ(run.at("troubles"), json::array());
  const std::string back = "https://app.prolific.com/submissions/complete?cc=";
  for (const auto& [end, code] : {std::pair("completed", "CDONE"), std::pair("refused", "CREFUSED"),
                                  std::pair("withdrawn", "CLEFT")}) {
    EXPECT_EQ(run.at(end).at("url"), back + code);
    EXPECT_NE(run.at(end).at("said").get<std::string>().find(code), std::string::npos) << end;
  }
  EXPECT_EQ(run.at("soon"), back + "CDONE");
  const auto said = [&](const char* who) { return run.at(who).at("said").get<std::string>(); };
  const std::string out = "https://app.prolific.com/out?pid=";
  EXPECT_EQ(run.at("screened_out").at("url"), out + "5f03");
  EXPECT_EQ(run.at("too_young").at("url"), out + "5f05");
  EXPECT_EQ(run.at("too_small").at("url"), out + "5f06");
  for (const char* who : {"too_young", "too_small"})
    EXPECT_NE(said(who).find("Thank you for your interest"), std::string::npos) << who;
  EXPECT_NE(run.at("too_small").at("asked").get<std::string>().find("at least 1000 × 600"),
            std::string::npos);
  // The code of an end has the place of the address of a completed one, and blanks are escaped.
  EXPECT_EQ(run.at("failed_attention").at("url"),
            "https://app.prolific.com/failed?study=study%201");
  EXPECT_EQ(run.at("withdrawn").at("offered"), 0) << "before there is anything to withdraw";
  EXPECT_EQ(run.at("withdrawn").at("still_offered"), 0);
  EXPECT_NE(said("withdrawn").find("your answers have been deleted"), std::string::npos);
  EXPECT_NE(said("withdrawn").find("We wanted to know"), std::string::npos);
  EXPECT_EQ(run.at("withdrawn").at("remembered").get<std::string>().find("5f07"),
            std::string::npos);
  EXPECT_NE(run.at("withdrawn").at("again").get<std::string>().find("have been deleted"),
            std::string::npos);
  EXPECT_EQ(run.at("session").get<std::string>().find("CDONE"), std::string::npos);
  EXPECT_EQ(run.at("search"), "") << "what the link held is in no address after it";
  EXPECT_EQ(run.at("link_again"), run.at("path")) << "the same link leads to the same session";
  const auto exported = [&](const char* name) {
    return run_program(
               {"node", "-e",
                "fetch(process.argv[1]).then(r => r.text()).then(t => process.stdout.write(t))",
                places.at("lab").get<std::string>() + name})
        .output;
  };
  std::map<std::string, std::string> ends;
  for (const auto& row : rows_in(exported("participants.csv"))) {
    ends[row.at("url_PROLIFIC_PID")] = row.at("ended") + " " + row.at("screening_fault");
    EXPECT_EQ(row.at("consent_version"), "2.1");
    EXPECT_EQ(row.at("consent_sha256").size(), 64u);
  }
  EXPECT_EQ(ends, (std::map<std::string, std::string>{{"5f01", "completed "},
                                                      {"5f04", "completed "},
                                                      {"5f05", "screened_out answer"},
                                                      {"5f06", "screened_out window"},
                                                      {"5f08", "completed "}}));
  const std::string answers = exported("answers.csv");
  EXPECT_EQ(answers.find("5f07"), std::string::npos) << "withdrew";
  const auto rows = rows_in(answers);
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) {
    if (row.at("participant") != rows.front().at("participant")) continue;
    EXPECT_EQ(row.at("url_PROLIFIC_PID"), "5f01");
    EXPECT_EQ(row.at("url_STUDY_ID"), "study 1");
    EXPECT_EQ(row.at("url_SESSION_ID"), "5f01-s");
    EXPECT_FALSE(row.contains("url_other"));
  }
}

// The third reads the study's own words, not those that are built in.
TEST_F(QuestionnairePage, LeadsBackFromTheOpenLinkWhenAllPlacesAreTaken) {
  std::string text = study_text;
  text.replace(text.find("participants: 3"), 15, "participants: 1");
  scratch->write("own.texts.yaml",
                 "language: en\nquestionnaire: {enough: There is no room left.}\n");
  text += "  texts: own.texts.yaml\n  recruitment: {prolific: {completed: CDONE}}\n";
  const fs::path manifest = scratch->write("one-place.yaml", text);
  const fs::path said = scratch->path() / "one-place.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", said.string(),
                        MIEN_PROGRAM, "study", "serve", manifest.string(), "--out",
                        (scratch->path() / "out").string(), "--port", "0", "--json", "--store",
                        (scratch->path() / "one-place.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(said), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const json read =
      output_of({(page_tests() / "all_places_taken.mjs").string(), places.at("join")});
  EXPECT_EQ(read.at("troubles"), json::array());
  EXPECT_EQ(read.at("first").at("path"), read.at("done"));
  EXPECT_NE(read.at("first").at("said").get<std::string>().find("CDONE"), std::string::npos);
  EXPECT_EQ(read.at("slow").at("path"), read.at("under"));
  EXPECT_EQ(read.at("slow").at("said").get<std::string>().find("no room"), std::string::npos);
  EXPECT_NE(read.at("third").at("said").get<std::string>().find("There is no room left."),
            std::string::npos)
      << read.at("third");
}

/// Participants with sound whom Prolific sends, in each of the ways to give a questionnaire.
class ProlificRoundTrip : public QuestionnairePage {
 protected:
  /// The manifest, written once.
  static fs::path manifest() {
    std::string text = study_text;
    for (const char* id : {"sad", "proud"}) {
      const std::string begin = std::string("{id: ") + id + ", ";
      text.replace(text.find(begin), begin.size(),
                   begin + "audio: {file: tone.wav, length: cut}, ");
    }
    text.replace(text.find("  reference: usual\n"), 19, R"(
  screening:
    sound: true
    questions:
      - {id: years, ask: "How old are you, in years?", answer: number, accept: {from: 18, to: 99}}
  recruitment: {prolific: {completed: CDONE, screened_out: COUT, withdrawn: CLEFT}}
)");
    scratch->write("tone.wav", wav_of_tone(3.0));
    return scratch->write("round.yaml", text);
  }

  static json taken(const std::string& mode, const std::string& given) {
    return output_of({(page_tests() / "round_trip.mjs").string(), mode, given});
  }

  static fs::path exported() {
    const fs::path there = scratch->path() / "round";
    must_run(mien_with({"study", "export", manifest().string(), "--out",
                        (scratch->path() / "out-round").string(), "-o", there.string()}));
    return there;
  }

  static void expect_ways_back(const json& told) {
    EXPECT_EQ(told.at("troubles"), json::array());
    const std::string back = "https://app.prolific.com/submissions/complete?cc=";
    for (const auto& [end, code] :
         {std::pair("completed", "CDONE"), std::pair("screened_out", "COUT"),
          std::pair("withdrawn", "CLEFT")}) {
      EXPECT_EQ(told.at(end).at("url"), back + code);
      EXPECT_NE(told.at(end).at("said").get<std::string>().find(code), std::string::npos) << end;
    }
    EXPECT_EQ(told.at("completed").at("reloads"), 1);
    const std::vector<bool> heard = told.at("completed").at("heard");
    EXPECT_GT(std::ranges::count(heard, true), 1);
  }

  /// The rows of whoever completed the study.
  static void expect_answers(const std::string& answers) {
    const auto rows = rows_in(answers);
    EXPECT_GT(rows.size(), 20u);
    for (const auto& row : rows) {
      EXPECT_EQ(row.at("url_PROLIFIC_PID"), "5f01");
      EXPECT_EQ(row.at("url_STUDY_ID"), "study");
      EXPECT_EQ(row.at("url_SESSION_ID"), "5f01-s");
      EXPECT_EQ(row.at("attempt"), row.at("trial") == "2" ? "2" : "1");
      EXPECT_EQ(row.at("plays_before"), row.at("trial") == "2"          ? "1"
                                        : row.at("kind") == "attention" ? ""
                                                                        : "0");
      EXPECT_TRUE(row.contains("volume_events"));
    }
  }

  static void expect_person(const std::map<std::string, std::string>& row, const json& told) {
    EXPECT_EQ(row.at("url_PROLIFIC_PID"), "5f01");
    EXPECT_EQ(row.at("ended"), "completed");
    EXPECT_EQ(row.at("years"), "27");
    EXPECT_EQ(row.at("tones_1"), std::to_string(told.at("completed").at("tones").get<int>()));
  }
};

TEST_F(ProlificRoundTrip, OfAnExportedPage) {
  const json told = taken("static", exported().string());
  expect_ways_back(told);
  const json& done = told.at("completed");
  expect_answers(done.at("answers"));
  expect_person(rows_in(done.at("participant").get<std::string>()).at(0), told);
  for (const char* end : {"withdrawn", "screened_out"})
    EXPECT_EQ(told.at(end).at("local").get<std::string>().find("sad-happy"), std::string::npos)
        << "no answers are left in the browser";
  EXPECT_EQ(told.at("withdrawn").at("local").get<std::string>().find("5f02"), std::string::npos);
}

TEST_F(ProlificRoundTrip, OfJatos) {
  const json told = taken("jatos", exported().string());
  expect_ways_back(told);
  const json& done = told.at("completed").at("session");
  expect_answers(done.at("result"));
  std::string people, out;
  for (const auto& [name, text] : done.at("files").items())
    if (name.ends_with("participants.csv")) people = text;
  expect_person(rows_in(people).at(0), told);
  const json& withdrawn = told.at("withdrawn").at("session");
  EXPECT_EQ(withdrawn.at("aborted"), true);
  EXPECT_FALSE(withdrawn.contains("result"));
  for (const auto& [name, text] : told.at("screened_out").at("session").at("files").items())
    if (name.ends_with("participants.csv")) out = text;
  EXPECT_EQ(rows_in(out).at(0).at("screening_fault"), "answer");
  EXPECT_EQ(rows_in(out).at(0).at("url_PROLIFIC_PID"), "5f03");
}

TEST_F(ProlificRoundTrip, OfAServer) {
  const fs::path said = scratch->path() / "round.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", said.string(),
                        MIEN_PROGRAM, "study", "serve", manifest().string(), "--out",
                        (scratch->path() / "out-round").string(), "--port", "0", "--json",
                        "--store", (scratch->path() / "round.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(said), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const json told = taken("served", places.at("join"));
  expect_ways_back(told);
  const auto exported = [&](const char* name) {
    return run_program(
               {"node", "-e",
                "fetch(process.argv[1]).then(r => r.text()).then(t => process.stdout.write(t))",
                places.at("lab").get<std::string>() + name})
        .output;
  };
  expect_answers(exported("answers.csv"));
  const auto people = rows_in(exported("participants.csv"));
  ASSERT_EQ(people.size(), 2u) << "who withdrew is not there";
  expect_person(people[0], told);
  EXPECT_EQ(people[1].at("url_PROLIFIC_PID"), "5f03");
  EXPECT_EQ(people[1].at("ended") + " " + people[1].at("screening_fault"), "screened_out answer");
}

}  // namespace
}  // namespace mien::test
