#include "pipeline/study/studio/studio_service.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/studio/studio_fixture.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

TEST_F(Studio, ShowsTheManifestAndWhatThereIsToChoose) {
  EXPECT_EQ(get({""}).body, "<p>");
  EXPECT_EQ(get({"studio.js"}).type, "text/javascript");
  const ordered_json studio = ordered_json::parse(get({"studio.json"}).body);
  EXPECT_EQ(studio["manifest"]["document"]["stimuli"].size(), 3u);
  EXPECT_EQ(studio["words"]["sets"].size(), 3u);
  EXPECT_GT(studio["words"]["recipes"].size(), 5u);
  const ordered_json choices =
      ordered_json::parse(post("choices", {{"document", document()}}).body);
  EXPECT_EQ(choices["examples"].size(), 10u);
  EXPECT_EQ(choices["sliders"]["adjectives"].size(), 45u);
  EXPECT_EQ(choices["simulated"], true);
}

TEST_F(Studio, MakesWhatMienMakes) {
  const HttpResponse response =
      post("motion", {{"document", document()}, {"show", "guess-1"}, {"against", "target-1"}});
  ASSERT_EQ(response.status, 200) << response.body;
  const ordered_json head = head_of(response);
  const Manifest manifest = load_manifest(file_.file(), process_environment());
  Motions motions(manifest);
  EXPECT_NEAR(head["reached"]["quickness"], motions.of("guess-1").reached[0].second, 1e-12);
  // As the sheets tell it, but of clips as they are written.
  EXPECT_NEAR(head["distance"]["D"], motions.distance("target-1", "guess-1").mean, 2e-3);
  EXPECT_EQ(head["distance"]["by_joint"].size(), 20u);
}

TEST_F(Studio, MakesModifiedDrafts) {
  ordered_json draft = document();
  draft["stimuli"][2]["modify"] = {{"emotion", "sad"}, {"posture", {{"head-flexion", 15}}}};
  const ordered_json head =
      head_of(post("motion", {{"document", draft}, {"show", "mix-1"}, {"against", "normal"}}));
  EXPECT_NE(head["modified"].get<std::string>().find("sad"), std::string::npos);
  EXPECT_GT(head["distance"]["D"].get<double>(), 0.01);
}

TEST_F(Studio, TellsWhatIsWrongWithADraft) {
  ordered_json draft = document();
  draft["stimuli"][0]["adjectives"]["quicknes"] = 0.5;
  const HttpResponse response = post("motion", {{"document", draft}, {"show", "target-1"}});
  EXPECT_EQ(response.status, 422);
  const ordered_json fault = ordered_json::parse(response.body)["faults"][0];
  EXPECT_EQ(fault["path"], "stimuli[0].adjectives.quicknes");
  EXPECT_NE(fault["remedy"].get<std::string>().find("quickness"), std::string::npos);
}

TEST_F(Studio, ChangesExamples) {
  ordered_json draft = document();
  draft["examples"]["set"] = "builtin:walks-27";
  const ordered_json choices = ordered_json::parse(post("choices", {{"document", draft}}).body);
  EXPECT_EQ(choices["examples"].size(), 27u);
  draft["examples"] = {{"set", "builtin:actors"}};
  EXPECT_EQ(ordered_json::parse(post("choices", {{"document", draft}}).body)["blendable"], false);
}

TEST_F(Studio, LetsNoRequestNameAFile) {
  write_file(folder_.path() / "secret.csv", "x\n");
  const auto status = [&](const std::string& pointer, const ordered_json& value) {
    ordered_json draft = document();
    draft[ordered_json::json_pointer(pointer)] = value;
    return post("motion", {{"document", draft}, {"show", "target-1"}}).status;
  };
  EXPECT_EQ(status("/seed", 8), 200);
  EXPECT_EQ(status("/examples/ratings", "secret.csv"), 422);
  EXPECT_EQ(status("/examples/set", {{"folder", "/etc"}}), 422);
  EXPECT_EQ(status("/examples/set", {{"folder", "captures"}}), 422);
  EXPECT_EQ(status("/look/figure", "/etc/passwd"), 422);
  EXPECT_EQ(status("/look/scene", "../my.set.yaml"), 422);
  EXPECT_EQ(status("/recipes", "secret.csv"), 422);
  EXPECT_EQ(status("/stimuli/0", {{"id", "target-1"}, {"clip", {{"file", "x.bvh"}}}}), 422);
  // Variables of the environment are not looked up for a request.
  EXPECT_EQ(status("/study", "${HOME}"), 422);
}

/// Each field that names a file, at each door that takes a document, of each kind of foreign file:
/// nothing is read of it, and nothing is saved.
TEST_F(Studio, HasOneDoorForWhateverADocumentNames) {
  const fs::path here = folder_.path();
  const test::TemporaryFolder elsewhere;
  const std::string secret = "top: secret: words\n";
  for (const fs::path& file :
       {elsewhere.path() / "secret.bvh", here / "notes.csv", here / "secretive"})
    write_file(file, secret);
  fs::create_symlink(elsewhere.path() / "secret.bvh", here / "link.bvh");
  fs::create_symlink(here / "secretive", here / "secretive.bvh");
  const std::vector<std::pair<std::string, std::string>> fields = {
      {"/examples/scales", ""},
      {"/examples/ratings", ""},
      {"/examples/set", "folder"},
      {"/recipes", ""},
      {"/look/scene", ""},
      {"/look/scene", "set"},
      {"/look/figure", "character"},
      {"/stimuli/0/look", "scene"},
      {"/questionnaire/consent", "file"},
      {"/questionnaire/instructions", "file"},
      {"/questionnaire/ending", "file"},
      {"/questionnaire/scales", "file"},
      {"/questionnaire/analysis/plan", "file"},
      {"/matching/consent", "file"},
      {"/stimuli/0/clip", "file"}};
  const std::string before = read_file(file_.file());
  for (const std::string& name :
       {elsewhere.path().string() + "/secret.bvh", std::string("notes.csv"),
        std::string("secretive"), std::string("link.bvh"), std::string("secretive.bvh"),
        std::string("/etc/passwd")}) {
    for (const auto& [at, member] : fields) {
      ordered_json draft = document();
      const ordered_json value = member.empty() ? ordered_json(name) : ordered_json{{member, name}};
      draft[ordered_json::json_pointer(at)] = value;
      if (at == "/stimuli/0/clip") draft["stimuli"][0].erase("adjectives");
      const ordered_json body = {{"document", draft},
                                 {"show", "target-1"},
                                 {"key", "x"},
                                 {"kind", "still"},
                                 {"text", before},
                                 {"stimulus", "mix-1"},
                                 {"version", file_.state().version}};
      for (const char* door : {"motion", "choices", "figure", "save", "jobs"}) {
        const HttpResponse response = post(door, body);
        EXPECT_EQ(response.status, 422) << door << " " << at << " " << name;
        EXPECT_NE(response.body.find("neither named in the manifest"), std::string::npos)
            << door << " " << at << ": " << response.body;
        EXPECT_EQ(response.body.find("secret: words"), std::string::npos) << response.body;
        EXPECT_EQ(response.body.find("root:"), std::string::npos) << response.body;
      }
    }
  }
  EXPECT_EQ(read_file(file_.file()), before);
}

/// What only looks like a path is no file.
TEST_F(Studio, LetsTextsHaveSlashes) {
  ordered_json draft = document();
  draft["stimuli"][0]["label"] = "walk/run no. 2.bvh";
  const HttpResponse response = post("choices", {{"document", draft}});
  EXPECT_EQ(response.status, 200) << response.body;
  // Nor is it known as a file thereafter.
  draft["recipes"] = "walk/run no. 2.bvh";
  EXPECT_EQ(post("choices", {{"document", draft}}).status, 422);
}

/// What the manifest names may stay, and be named elsewhere in it.
TEST_F(Studio, KeepsTheFilesThatTheManifestNames) {
  write_file(folder_.path() / "my.recipes.yaml",
             read_file(fs::path(MIEN_SOURCE_DIR) / "manifests" / "emotions.recipes.yaml"));
  ordered_json draft = document();
  draft["recipes"] = "my.recipes.yaml";
  EXPECT_EQ(post("choices", {{"document", draft}}).status, 422);
  write_file(file_.file(), read_file(file_.file()) + "recipes: my.recipes.yaml\n");
  post("reload", ordered_json::object());
  EXPECT_EQ(post("choices", {{"document", draft}}).status, 200);
  draft["recipes"] = "./my.recipes.yaml";
  EXPECT_EQ(post("choices", {{"document", draft}}).status, 200);
}

TEST_F(Studio, AnswersNobodyElse) {
  EXPECT_EQ(get({"nothing"}).status, 404);
  HttpRequest asked = request("GET", {"studio.json"});
  asked.path[0] = std::string(32, 'a');
  EXPECT_EQ(service_.answer(asked).status, 404);
  asked.path[0] = service_.link().substr(0, 31);
  EXPECT_EQ(service_.answer(asked).status, 404);

  asked = request("GET", {"studio.json"});
  for (const char* host : {"evil.example", "evil.example:4711", "127.0.0.1", "127.0.0.1:80", ""}) {
    asked.headers["host"] = host;
    EXPECT_EQ(service_.answer(asked).status, 421) << host;
  }
  asked = request("POST", {"reload"}, "{}");
  asked.headers["origin"] = "http://evil.example";
  EXPECT_EQ(service_.answer(asked).status, 403);
  asked.headers["origin"] = "null";
  EXPECT_EQ(service_.answer(asked).status, 403);
  asked.headers["origin"] = "http://127.0.0.1:4711";
  EXPECT_EQ(service_.answer(asked).status, 200);
  asked.headers["sec-fetch-site"] = "cross-site";
  EXPECT_EQ(service_.answer(asked).status, 403);

  asked = request("GET", {""});
  asked.headers["sec-fetch-site"] = "cross-site";
  EXPECT_EQ(service_.answer(asked).status, 403);
  asked.headers["sec-fetch-mode"] = "navigate";
  asked.headers["sec-fetch-dest"] = "document";
  EXPECT_EQ(service_.answer(asked).status, 200);
  asked.headers["sec-fetch-dest"] = "iframe";
  EXPECT_EQ(service_.answer(asked).status, 403);
}

TEST_F(Studio, RefusesWhatItsPageDoesNotSend) {
  HttpRequest asked = request("POST", {"save"}, "{}");
  asked.headers["content-type"] = "text/plain";
  EXPECT_EQ(service_.answer(asked).status, 415);
  for (const char* body :
       {"", "[]", "{}", "7", "{\"document\": 1}", "{\"document\": {}, \"version\": 1}",
        "{\"document\": [], \"version\": \"x\"}", "\xff"}) {
    for (const char* what : {"save", "motion", "jobs", "choices"}) {
      const int status = service_.answer(request("POST", {what}, body)).status;
      EXPECT_TRUE(status == 400 || status == 422 || status == 409) << what << " " << body << status;
    }
  }
  for (const std::string& deep :
       {std::string(100000, '['),
        "{\"document\": " + std::string(1000, '[') + std::string(1000, ']') + "}"})
    EXPECT_EQ(service_.answer(request("POST", {"choices"}, deep)).status, 400);
  EXPECT_EQ(service_.answer(request("PUT", {"save"}, "{}")).status, 405);
  EXPECT_EQ(service_.answer(request("POST", {"my.yaml"}, "{}")).status, 404);
  EXPECT_EQ(get({"jobs", "x"}).status, 404);
  EXPECT_EQ(get({"jobs", "1"}).status, 404);
  EXPECT_EQ(get({"jobs", "1", "result"}).status, 404);
  EXPECT_EQ(get({"jobs"}).status, 404);
}

TEST_F(Studio, SavesOnceAndTellsWhatWasChangedElsewhere) {
  ordered_json draft = document();
  draft["stimuli"][0]["adjectives"]["quickness"] = 0.9;
  const std::string text = brisker(read_file(file_.file()));
  const auto save = [&](const std::string& version) {
    return post("save", {{"document", draft}, {"text", text}, {"version", version}});
  };
  const std::string version = file_.state().version;
  const HttpResponse saved = save(version);
  EXPECT_EQ(saved.status, 200);
  EXPECT_EQ(read_file(file_.file()), text);
  EXPECT_EQ(save(version).status, 409);
  write_file(file_.file(), text + "# elsewhere\n");
  const HttpResponse refused = save(ordered_json::parse(saved.body)["version"]);
  EXPECT_EQ(refused.status, 409);
  // What stands there now comes with the refusal, and can be written over.
  const ordered_json found = ordered_json::parse(refused.body)["manifest"];
  EXPECT_EQ(found["text"], text + "# elsewhere\n");
  EXPECT_EQ(found["document"], draft);
  const ordered_json reloaded = ordered_json::parse(post("reload", ordered_json::object()).body);
  EXPECT_EQ(reloaded, found);
  EXPECT_EQ(save(found["version"]).status, 200);
  EXPECT_EQ(read_file(file_.file()), text);
}

/// Nor can a text say more than the document that was looked at, in variables or in aliases.
TEST_F(Studio, SavesNoTextThatSaysSomethingElse) {
  const std::string before = read_file(file_.file());
  for (const std::string& text :
       {brisker(before), before + "recipes: /etc/passwd\n", before + "title: ${PATH}\n",
        before + "---\n", before + "x: [\n", std::string()}) {
    const HttpResponse refused = post(
        "save", {{"document", document()}, {"text", text}, {"version", file_.state().version}});
    EXPECT_EQ(refused.status, 422) << text;
    EXPECT_EQ(refused.body.find("/bin"), std::string::npos) << refused.body;
    EXPECT_EQ(read_file(file_.file()), before);
  }
}

TEST_F(Studio, MakesStillsAndVideosOneAtATime) {
  ordered_json draft = document();
  draft["output"]["size"] = {64, 48};
  draft["output"]["cycles"] = 1;
  const ordered_json still = {{"document", draft},
                              {"kind", "still"},
                              {"stimulus", "mix-1"},
                              {"seconds", 0.4},
                              {"quality", "draft"}};
  const ordered_json begun = ordered_json::parse(post("jobs", still).body);
  const ordered_json made = ended(begun["job"]);
  EXPECT_EQ(made["state"], "done") << made["told"];
  const HttpResponse picture = get({"jobs", std::to_string(begun["job"].get<int>()), "result"});
  EXPECT_EQ(picture.type, "image/png");
  ASSERT_TRUE(picture.part);
  EXPECT_EQ(read_file(picture.part->file).substr(1, 3), "PNG");

  ordered_json video = still;
  video["kind"] = "video";
  const ordered_json filmed = ordered_json::parse(post("jobs", video).body);
  EXPECT_EQ(post("jobs", still).status, 409);
  const ordered_json film = ended(filmed["job"]);
  EXPECT_EQ(film["state"], "done") << film["told"];
  EXPECT_EQ(film["share"], 1.0);
  // A page that is opened now learns of it.
  EXPECT_EQ(ordered_json::parse(get({"studio.json"}).body)["job"], film);
  EXPECT_TRUE(fs::exists(folder_.path() / "out" / "videos" / "mix-1.mp4"));
  // The manifest itself asks for nothing of the kind.
  EXPECT_FALSE(fs::exists(folder_.path() / "out" / "quickstart"));
}

TEST_F(Studio, StopsAVideo) {
  const ordered_json video = {
      {"document", document()}, {"kind", "video"}, {"stimulus", "mix-1"}, {"quality", "final"}};
  const int job = ordered_json::parse(post("jobs", video).body)["job"];
  const HttpResponse stopped =
      service_.answer(request("POST", {"jobs", std::to_string(job), "cancel"}, "{}"));
  EXPECT_EQ(stopped.status, 200);
  EXPECT_EQ(ended(job)["state"], "cancelled");
  EXPECT_EQ(get({"jobs", std::to_string(job), "result"}).status, 404);
}

}  // namespace
}  // namespace mien::pipeline
