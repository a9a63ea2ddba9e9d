// Sessions that end early, and pages that are loaded again
// (page/tests/questionnaire/early_ends.mjs).

#include <map>
#include <string>

#include "end_to_end/questionnaire_page.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class EarlyEndsPage : public QuestionnairePage {
 protected:
  static fs::path manifest() {
    std::string text = study_text;
    text += R"(
  debriefing: We wanted to know whether the mood of a walk can be seen.
  screening:
    questions:
      - {id: years, ask: "How old are you, in years?", answer: number, accept: {from: 18, to: 99}}
  recruitment:
    prolific: {completed: CDONE, screened_out: COUT, refused: CREFUSED}
    redirect: {withdrawn: "https://app.prolific.com/left?pid={PROLIFIC_PID}"}
)";
    return scratch->write("ends.yaml", text);
  }

  static std::string exported() {
    const fs::path there = scratch->path() / "ends";
    must_run(mien_with({"study", "export", manifest().string(), "--out",
                        (scratch->path() / "out").string(), "-o", there.string()}));
    return there.string();
  }

  static json told(const std::string& mode, const std::string& given) {
    return output_of({(page_tests() / "early_ends.mjs").string(), mode, given});
  }

  static void expect_in(const json& said, const std::string& what) {
    EXPECT_NE(said.get<std::string>().find(what), std::string::npos) << said;
  }
  static void expect_not_in(const json& said, const std::string& what) {
    EXPECT_EQ(said.get<std::string>().find(what), std::string::npos) << said;
  }

  /// The page of somebody who was screened out, each time the same; no answers are kept.
  static void expect_out(const json& out) {
    expect_in(out.at("first"), "you cannot take part");
    expect_in(out.at("first"), "Your code: COUT");
    EXPECT_EQ(out.at("again"), out.at("first"));
    EXPECT_EQ(out.at("at_link"), out.at("first"));
    expect_not_in(out.at("stored"), "years");
  }

  /// The completion code and the way back come first; the code for deletion is named as one, apart.
  static void expect_apart(const json& end, const std::string& completion) {
    const std::string said = end;
    const std::size_t code = said.find(completion), back = said.find("Return to Prolific"),
                      deletion = said.find("Deletion code");
    EXPECT_LT(code, back) << said;
    EXPECT_LT(back, deletion) << said;
    EXPECT_NE(said.find("needed for nothing else", deletion), std::string::npos) << said;
    EXPECT_EQ(said.find(completion, deletion), std::string::npos) << said;
  }

  static void expect_withdrawn(const json& withdrawn) {
    expect_in(withdrawn.at("first"), "your answers have been deleted");
    expect_in(withdrawn.at("first"), "We wanted to know whether");
    EXPECT_EQ(withdrawn.at("again"), withdrawn.at("first"));
    EXPECT_EQ(withdrawn.at("at_link"), withdrawn.at("first"));
    EXPECT_EQ(withdrawn.at("led_to"), "https://app.prolific.com/left?pid=5f12");
    expect_not_in(withdrawn.at("stored"), "5f12");
    expect_not_in(withdrawn.at("stored"), "years");
  }
};

TEST_F(EarlyEndsPage, AreRememberedInTheBrowserByAnExportedPage) {
  const json ends = told("static", exported());
  expect_out(ends.at("out"));
  expect_withdrawn(ends.at("withdrawn"));
  const json& shared = ends.at("shared");
  EXPECT_EQ(shared.at("troubles"), json::array());
  expect_out(shared.at("out"));
  EXPECT_EQ(shared.at("other_session"), shared.at("out").at("first")) << "the same person";
  EXPECT_TRUE(shared.at("is_other_asked")) << "another person at the same browser";
  EXPECT_EQ(shared.at("first_still_out"), shared.at("out").at("first"));
  // Whoever completes it has what is theirs, and the files to send.
  expect_in(shared.at("end"), "please send the files to the researchers");
  expect_in(shared.at("end"), "description-answers_data.csv");
  expect_in(shared.at("end"), "CDONE");
  expect_apart(shared.at("end"), "CDONE");
  EXPECT_EQ(shared.at("end_buttons"), (json{"Save the files again", "Return to Prolific"}));
  EXPECT_EQ(rows_in(shared.at("saved_again").get<std::string>()).at(0).at("url_PROLIFIC_PID"),
            "5f02");
  EXPECT_NE(shared.at("end_again").get<std::string>().find("We wanted to know"), std::string::npos);
  // Links that name nobody: remembered, too, until the next participant sits down.
  expect_in(shared.at("nameless").at("first"), "COUT");
  EXPECT_EQ(shared.at("nameless").at("again"), shared.at("nameless").at("first"));
  EXPECT_TRUE(shared.at("is_plan_asked"));
  EXPECT_TRUE(shared.at("is_next_asked"));
  EXPECT_EQ(shared.at("still_out"), shared.at("out").at("first"));
  EXPECT_TRUE(shared.at("is_anew")) << "once everything was forgotten";
  expect_in(shared.at("experimenter"), "completed");
  const auto listed = rows_in(shared.at("list").get<std::string>());
  ASSERT_EQ(listed.size(), 2u);
  for (const auto& row : listed) {
    EXPECT_EQ(row.at("ended"), "screened_out");
    EXPECT_EQ(row.at("screening_fault"), "answer");
    EXPECT_EQ(row.at("finished"), "0");
    EXPECT_FALSE(row.contains("years"));
    EXPECT_FALSE(row.at("consented_at").empty());
  }
  EXPECT_EQ(listed[0].at("url_PROLIFIC_PID"), "5f01");
  EXPECT_EQ(listed[1].at("url_PROLIFIC_PID"), "");
}

TEST_F(EarlyEndsPage, AreRememberedInTheBrowserOnJatos) {
  const json ends = told("jatos", exported());
  expect_out(ends.at("out"));
  expect_in(ends.at("out_in_new_run"), "COUT");
  expect_withdrawn(ends.at("withdrawn"));
  EXPECT_TRUE(ends.at("is_other_asked"));
}

TEST_F(EarlyEndsPage, AreKnownToAServer) {
  const fs::path said = scratch->path() / "ends.txt";
  const Running server({"sh", "-c", "told=$1; shift; exec \"$@\" >\"$told\"", "sh", said.string(),
                        MIEN_PROGRAM, "study", "serve", manifest().string(), "--out",
                        (scratch->path() / "out").string(), "--port", "0", "--json", "--store",
                        (scratch->path() / "ends.db").string()});
  json places;
  for (int tries = 0; tries < 3000 && !places.is_object(); ++tries) {
    pause_for(0.1);
    places = json::parse(text_of(said), nullptr, false);
  }
  ASSERT_TRUE(places.is_object());
  const auto own = rows_in(text_of(places.at("links").get<std::string>()));
  const json ends =
      told("served", json{{"join", places.at("join")}, {"own", own.at(0).at("link")}}.dump());
  expect_withdrawn(ends.at("withdrawn"));
  expect_in(ends.at("refused").at("first"), "CREFUSED");
  EXPECT_EQ(ends.at("refused").at("again"), ends.at("refused").at("first"));
  EXPECT_EQ(ends.at("elsewhere").at("other"), ends.at("elsewhere").at("first"));
}

}  // namespace
}  // namespace mien::test
