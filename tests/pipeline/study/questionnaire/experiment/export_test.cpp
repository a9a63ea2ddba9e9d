#include "pipeline/study/questionnaire/experiment/export.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/page_bundle.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/study/questionnaire/experiment/jatos_archive.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::TemporaryFolder;

constexpr char study_text[] = R"(mien: 1
study: gaits
seed: 7
examples: {set: builtin:walks-10}
stimuli:
  - {id: very-sad, weights: {sad: 1}}
  - {id: very-proud, weights: {proud: 1}}
  - {id: usual, weights: {normal: 1}}
questionnaire:
  title: How does this person walk?
  participants: 3
  consent: |
    One line
    and its next.

    Another paragraph.
  scales: emotions
  stimuli: [very-sad, very-proud]
  practice: [usual]
  attention: {every: 1}
  demographics: [{id: age, ask: "How old are you?", answer: number}]
)";

Manifest study_of(const std::string& text) {
  ManifestReading reading =
      parse_manifest(text, "/nowhere/gaits.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  return std::move(reading.manifest);
}

/// Media and pages that hold next to nothing.
class Exported {
 public:
  explicit Exported(const std::string& text = study_text)
      : manifest(study_of(text)), plans(plan_sessions(manifest)) {
    for (const char* id : {"very-sad", "very-proud", "usual"}) {
      const fs::path file = folder.path() / id;
      write_file(file, std::string("film of ") + id);
      media[id] = {.file = file,
                   .token = media_token(manifest, id),
                   .ending = ".mp4",
                   .type = "video/mp4",
                   .sha256 = std::string(64, 'a'),
                   .seconds = 2.0,
                   .width = 64,
                   .height = 48};
    }
    for (const char* name : {"LICENSES.txt", "questionnaire.css", "questionnaire.js"})
      write_file(folder.path() / name, name);
    write_file(folder.path() / "index.html",
               "<meta name=\"mien-mode\" content=\"static\">\n"
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'\">\n"
               "<script src=\"questionnaire.js\" defer></script>\n");
  }

  ZipFiles files() const { return exported_questionnaire(manifest, plans, media, folder.path()); }

  TemporaryFolder folder;
  Manifest manifest;
  std::vector<SessionPlan> plans;
  MediaFiles media;
};

TEST(Export, TellsNoConditionInWhatParticipantsAreGiven) {
  const Exported study;
  for (const auto& [path, bytes] : study.files()) {
    for (const char* id : {"sad", "proud", "usual"}) {
      EXPECT_EQ(path.find(id), path.npos) << path;
      if (path == "index.html") {
        EXPECT_EQ(bytes.find(id), bytes.npos);
      }
    }
  }
}

TEST(Export, GivesTheSameBytesEachTime) { EXPECT_EQ(Exported().files(), Exported().files()); }

TEST(Export, HoldsEveryFileThatItsExperimentNames) {
  const Exported study;
  const ZipFiles files = study.files();
  const json experiment = json::parse(files.at("experiment.json"));
  EXPECT_EQ(experiment.at("media").size(), 3U);
  for (const auto& [token, media] : experiment.at("media").items()) {
    const std::string stimulus = experiment.at("stimuli").at(token);
    EXPECT_EQ(files.at(media.at("file")), "film of " + stimulus);
  }
  EXPECT_EQ(files.at("experiment.js"),
            "globalThis.mienExperiment = " +
                nlohmann::ordered_json::parse(files.at("experiment.json")).dump() + ";\n");
}

TEST(Export, LaysOutAStudyAsJatosImportsIt) {
  const Exported study;
  const ZipFiles files = study.files();
  const ZipFiles inside = unzipped(files.at("gaits.jzip"), "gaits.jzip");
  const json described = json::parse(inside.at("gaits.jas"));
  EXPECT_EQ(described.at("version"), "3");
  const json& jatos = described.at("data");
  EXPECT_EQ(jatos.at("title"), "How does this person walk?");
  EXPECT_EQ(jatos.at("dirName"), "gaits");
  EXPECT_EQ(jatos.at("componentList").size(), 1U);
  EXPECT_EQ(jatos.at("batchList").size(), 1U);
  EXPECT_EQ(jatos.at("componentList")[0].at("htmlFilePath"), "index.html");
  EXPECT_TRUE(jatos.at("componentList")[0].at("reloadable"));
  for (const auto& [path, bytes] : inside)
    EXPECT_TRUE(path == "gaits.jas" || path.starts_with("gaits/")) << path;
  const std::string& page = inside.at("gaits/index.html");
  EXPECT_NE(page.find("content=\"jatos\""), page.npos);
  EXPECT_NE(page.find("<script src=\"jatos.js\"></script>"), page.npos);
  EXPECT_EQ(page.find("Content-Security-Policy"), page.npos);
  EXPECT_TRUE(inside.contains("gaits/experiment.js"));
}

TEST(Export, IsReplacedByTheNextAndKeepsWhatWasAdded) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "questionnaire";
  write_export({{"index.html", "old"}, {"media/a.mp4", "old film"}}, place);
  write_file(place / "answers.csv", "of somebody");
  write_export({{"index.html", "new"}, {"media/b.mp4", "new film"}}, place);
  EXPECT_EQ(read_file(place / "index.html"), "new");
  EXPECT_FALSE(fs::exists(place / "media/a.mp4"));
  EXPECT_EQ(read_file(place / "answers.csv"), "of somebody");
}

TEST(Export, RemovesAndWritesNothingElsewhere) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "questionnaire", thesis = folder.path() / "thesis.tex";
  write_file(thesis, "mine");
  write_export({{"index.html", "old"}, {"media/a.mp4", "old film"}}, place);
  fs::path mark;
  for (const auto& entry : fs::directory_iterator(place)) {
    if (entry.path().filename().string().starts_with(".")) mark = entry.path();
  }
  ASSERT_FALSE(mark.empty());
  write_file(mark, "media/../../thesis.tex\n../thesis.tex\n" + thesis.string() + "\n..\n\n.\n");
  write_export({{"index.html", "new"}}, place);
  EXPECT_EQ(read_file(thesis), "mine");
  for (const std::string& name : {std::string("index.html"), mark.filename().string()}) {
    fs::remove(place / name);
    fs::create_symlink(thesis, place / name);
    EXPECT_THROW(write_export({{"index.html", "newer"}}, place), Error) << name;
    EXPECT_EQ(read_file(thesis), "mine") << name;
    fs::remove(place / name);
    write_file(place / name, "");
  }
}

TEST(Export, OfAnotherDesignDoesNotMixWithAnswersToTheFirst) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "questionnaire";
  const Exported exported;
  write_export(exported.files(), place);
  const std::string design = design_hash(exported.manifest, exported.plans);
  EXPECT_NO_THROW(refuse_answers_to_other_design(place, "another"));  // nobody has answered yet
  write_file(place / "answers/data/subject-p001_description-answers_data.csv", "of somebody");
  EXPECT_NO_THROW(refuse_answers_to_other_design(place, design));
  try {
    refuse_answers_to_other_design(place, "another");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("holds answers to a different questionnaire"),
              std::string::npos)
        << error.what();
  }
}

TEST(Export, WritesIntoNoOtherFolder) {
  const TemporaryFolder folder;
  write_file(folder.path() / "thesis.tex", "mine");
  EXPECT_THROW(write_export({{"index.html", "new"}}, folder.path()), Error);
  EXPECT_FALSE(fs::exists(folder.path() / "index.html"));
  EXPECT_THROW(write_export({}, folder.path() / "thesis.tex"), Error);
}

TEST(Experiment, HasWhatThePageNeeds) {
  const Exported study;
  const json experiment = experiment_json(study.manifest, study.plans, study.media);
  EXPECT_EQ(experiment.at("format"), "mien-questionnaire-1");
  EXPECT_EQ(experiment.at("texts").at("consent"),
            (json{"One line and its next.", "Another paragraph."}));
  EXPECT_EQ(experiment.at("sessions").size(), 3U);
  EXPECT_EQ(experiment.at("items").size(), 6U);
  const json& trials = experiment.at("sessions")[0].at("trials");
  EXPECT_EQ(trials[0].at("media"), json{media_token(study.manifest, "usual")});
  EXPECT_TRUE(trials[0].at("practice"));
  EXPECT_EQ(trials[2].at("kind"), "attention");
  EXPECT_FALSE(trials[2].at("expected").get<std::string>().empty());
  EXPECT_TRUE(experiment.at("sessions")[0].at("seed").is_string());
}

TEST(Experiment, JoinsLinesOfJapaneseWithoutABlank) {
  EXPECT_EQ(paragraphs_of("歩く\n人\n\n次", "ja"), (std::vector<std::string>{"歩く人", "次"}));
  EXPECT_TRUE(paragraphs_of("\n \n", "en").empty());
}

/// The study in German, English and Japanese, between which browsers choose.
std::string study_in_languages() {
  std::string text = study_text;
  const auto put = [&](const std::string& before, const std::string& after) {
    const std::size_t at = text.find(before);
    EXPECT_NE(at, text.npos) << before;
    text.replace(at, before.size(), after);
  };
  put("title: How does this person walk?",
      "language: {browser: [en, ja]}\n  title: {en: Walk, ja: 歩行}");
  put("consent: |\n    One line\n    and its next.\n\n    Another paragraph.\n",
      "consent: {en: 'Yes.', ja: はい。}\n");
  put("[{id: age, ask: \"How old are you?\", answer: number}]",
      "[{id: hand, ask: {en: Hand, ja: 手}, answer: {en: [left, right], ja: [左, 右]}}]\n"
      "  screening: {questions: [{id: eyes, ask: {en: Eyes, ja: 目}, "
      "answer: {en: ['yes', 'no'], ja: [はい, いいえ]}}]}");
  return text;
}

TEST(Experiment, HasAllTextsInEachLanguage) {
  const Exported study(study_in_languages());
  const json experiment = experiment_json(study.manifest, study.plans, study.media);
  EXPECT_EQ(experiment.at("language"), "en");
  EXPECT_EQ(experiment.at("title"), "Walk");
  EXPECT_EQ(experiment.at("demographics")[0].at("answer"), (json{"left", "right"}));
  EXPECT_EQ(experiment.at("screening").at("questions")[0].at("ask"), "Eyes");
  EXPECT_EQ(experiment.at("languages").at("en"), json::object());
  const json& japanese = experiment.at("languages").at("ja");
  EXPECT_EQ(japanese.at("title"), "歩行");
  EXPECT_EQ(japanese.at("texts").at("consent"), json{"はい。"});
  EXPECT_EQ(japanese.at("items").at("sad-happy").at("low"), "悲しい");
  EXPECT_EQ(experiment.at("items").at("sad-happy").at("low"), "sad");
  EXPECT_EQ(japanese.at("demographics")[0].at("ask"), "手");
  EXPECT_EQ(japanese.at("demographics")[0].at("answer"), (json{"左", "右"}));
  EXPECT_EQ(japanese.at("demographics")[0].at("values"), (json{"left", "right"}));
  EXPECT_EQ(japanese.at("screening").at("questions")[0].at("values"), (json{"yes", "no"}));
  EXPECT_EQ(experiment.at("consent").at("sha256"), sha256_of("Yes."));
  EXPECT_EQ(japanese.at("consent").at("sha256"), sha256_of("はい。"));
  EXPECT_EQ(japanese.at("settings"), experiment.at("settings"));
}

TEST(Experiment, IsAnotherDesignInOtherWordsOfAnyLanguage) {
  const auto design = [](const std::string& text) {
    const Manifest manifest = study_of(text);
    return design_hash(manifest, plan_sessions(manifest));
  };
  const std::string text = study_in_languages();
  for (const auto& [before, after] :
       std::vector<std::pair<std::string, std::string>>{{"ja: 歩行", "ja: 歩き"},
                                                        {"ja: はい。", "ja: ええ。"},
                                                        {"[左, 右]", "[左手, 右手]"},
                                                        {"[en, ja]", "[ja, en]"}}) {
    std::string other = text;
    other.replace(other.find(before), before.size(), after);
    EXPECT_NE(design(other), design(text)) << after;
  }
}

TEST(Experiment, IsAnotherDesignInOtherWordsOfScales) {
  const TemporaryFolder folder;
  const auto design = [&](const std::string& german) {
    write_file(folder.path() / "mood.scales.yaml",
               "scales: {mood: {low: sad, high: happy, de: [" + german + ", froh]}}\n");
    const ManifestReading reading = parse_manifest(
        "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
        "stimuli: [{id: a, weights: {sad: 1}}, {id: b, weights: {normal: 1}}]\n"
        "questionnaire: {participants: 2, language: {browser: [en, de]}, "
        "scales: {file: mood.scales.yaml}}\n",
        folder.path() / "m.yaml", [](const std::string&) { return std::nullopt; });
    EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
    return design_hash(reading.manifest, plan_sessions(reading.manifest));
  };
  EXPECT_EQ(design("traurig"), design("traurig"));
  EXPECT_NE(design("traurig"), design("betrübt"));
}

// Such a study keeps the hash that it had before pages had languages to choose from.
TEST(Experiment, OfOneLanguageIsTheDesignThatItWas) {
  const Manifest manifest = study_of(study_text);
  EXPECT_EQ(design_hash(manifest, plan_sessions(manifest)), "1960b6f30eaf096ddd632208132798e7");
}

TEST(Experiment, CallsMediaBySeed) {
  const Manifest one = study_of(study_text);
  Manifest other = one;
  other.seed = 8;
  EXPECT_NE(media_token(one, "very-sad"), media_token(one, "usual"));
  EXPECT_NE(media_token(one, "very-sad"), media_token(other, "very-sad"));
}

TEST(Media, MustBeSuchAsBrowsersPlay) {
  Manifest manifest = study_of(study_text);
  for (Stimulus& stimulus : manifest.stimuli) stimulus.output.video = {render::VideoKind::gif};
  EXPECT_THROW(with_media(manifest), Error);
}

TEST(Media, OfATurnedViewIsTheMotion) {
  Manifest manifest = study_of(study_text);
  manifest.questionnaire->view = ShownAs::turn;
  for (const Stimulus& stimulus : with_media(manifest).stimuli)
    EXPECT_EQ(std::ranges::count(stimulus.output.clips, "glb"), 1) << stimulus.id;
}

TEST(JatosArchive, HasNamesThatStayTheSame) {
  EXPECT_EQ(named_uuid("a"), named_uuid("a"));
  EXPECT_NE(named_uuid("a"), named_uuid("b"));
  const std::string uuid = named_uuid("a");
  EXPECT_EQ(uuid.size(), 36U);
  EXPECT_EQ(uuid[14], '8');
  EXPECT_NE(std::string("89ab").find(uuid[19]), std::string::npos);
}

TEST(PageBundle, LiesBesideTheProgram) {
  const TemporaryFolder folder;
  EXPECT_EQ(page_beside(folder.path() / "bin/mien", "questionnaire"), fs::path());
  make_folder(folder.path() / "share/mien/pages/questionnaire");
  write_file(folder.path() / "share/mien/pages/questionnaire/questionnaire.js", "");
  EXPECT_EQ(page_beside(folder.path() / "bin/mien", "questionnaire"),
            folder.path() / "share/mien/pages/questionnaire");
}

}  // namespace
}  // namespace mien::pipeline
