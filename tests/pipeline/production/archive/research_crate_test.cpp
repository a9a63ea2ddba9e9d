#include "pipeline/production/archive/research_crate.h"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/archive/made_study.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

const BagInfo whole_info{.organization = "University of Somewhere",
                         .contact_name = "A. Walker",
                         .contact_email = "walker@example.org",
                         .description = "Twelve walks",
                         .license = "CC-BY-4.0",
                         .left_out = "",
                         .published = "2026-11-30"};

/// The entities of a crate by their ids, which must differ.
std::map<std::string, json> entities_of(const std::string& metadata) {
  std::map<std::string, json> entities;
  const json crate = json::parse(metadata);
  for (const json& entity : crate.at("@graph")) {
    const std::string id = entity.at("@id").get<std::string>();
    EXPECT_TRUE(entities.emplace(id, entity).second) << id << " is described twice";
    EXPECT_TRUE(entity.contains("@type")) << id;
  }
  return entities;
}

/// Adds the ids that a value refers to.
void add_references(const json& value, std::set<std::string>& ids) {
  if (value.is_object() && value.size() == 1 && value.contains("@id")) {
    ids.insert(value.at("@id").get<std::string>());
  } else if (value.is_structured()) {
    for (const json& part : value) add_references(part, ids);
  }
}

std::set<std::string> ids_in(const json& references) {
  std::set<std::string> ids;
  add_references(references, ids);
  return ids;
}

// RO-Crate 1.1: the metadata descriptor, the root data entity and its required properties.
TEST(ResearchCrate, HasWhatTheSpecificationRequires) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  const std::string metadata = crate_metadata(contents, payload_of(contents), whole_info);
  const json crate = json::parse(metadata);
  EXPECT_EQ(crate.size(), 2u) << "only @context and @graph";
  EXPECT_EQ(crate.at("@context").at(0).get<std::string>(), "https://w3id.org/ro/crate/1.1/context");
  auto entities = entities_of(metadata);
  const json& descriptor = entities.at("ro-crate-metadata.json");
  EXPECT_EQ(descriptor.at("@type").get<std::string>(), "CreativeWork");
  EXPECT_EQ(ids_in(descriptor.at("about")), (std::set<std::string>{"./"}));
  EXPECT_TRUE(ids_in(descriptor.at("conformsTo")).contains("https://w3id.org/ro/crate/1.1"));
  const json& root = entities.at("./");
  EXPECT_EQ(root.at("@type").get<std::string>(), "Dataset");
  EXPECT_EQ(root.at("name").get<std::string>(), "Human motion stimuli: tiny");
  EXPECT_EQ(root.at("description").get<std::string>(), "Twelve walks");
  EXPECT_EQ(root.at("datePublished").get<std::string>(), "2026-11-30");
  const json& licence = entities.at(root.at("license").at("@id").get<std::string>());
  EXPECT_EQ(licence.at("@id").get<std::string>(), "https://spdx.org/licenses/CC-BY-4.0");
  const json& owner = entities.at(root.at("author").at("@id").get<std::string>());
  EXPECT_EQ(owner.at("name").get<std::string>(), "University of Somewhere");
  EXPECT_TRUE(lacking_of_crate(whole_info).empty());
  EXPECT_EQ(lacking_of_crate({}),
            (std::vector<std::string>{"--published", "--license", "--organization"}));
}

// Flattened JSON-LD: whatever is referred to is described, but for the specification itself.
TEST(ResearchCrate, DescribesEverythingThatItRefersTo) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  for (const BagInfo& info : {BagInfo{}, whole_info}) {
    const auto entities = entities_of(crate_metadata(contents, payload_of(contents), info));
    std::set<std::string> ids;
    for (const auto& [id, entity] : entities) add_references(entity, ids);
    ASSERT_EQ(ids.erase("https://w3id.org/ro/crate/1.1"), 1u);
    for (const std::string& id : ids) EXPECT_TRUE(entities.contains(id)) << id;
  }
}

TEST(ResearchCrate, ListsEachFileOnceAndASequenceAsOneFolder) {
  const test::MadeStudy study;
  write_file(study / "notes of mine, 100 %.txt", "mine");
  const StudyContents contents = contents_of(study.folder());
  const std::vector<PayloadFile> payload = payload_of(contents);
  const auto entities = entities_of(crate_metadata(contents, payload, {}));
  const std::set<std::string> parts = ids_in(entities.at("./").at("hasPart"));
  EXPECT_TRUE(parts.contains("notes%20of%20mine%2C%20100%20%25.txt"));
  EXPECT_TRUE(parts.contains("frames/a/"));
  EXPECT_EQ(entities.at("frames/a/").at("description").get<std::string>(),
            std::to_string(contents.find("frames/a")->frames) + " frames");
  std::size_t files = 0;
  for (const PayloadFile& file : payload) {
    if (file.path.starts_with("frames/")) continue;
    ++files;
    if (file.path.find(' ') != std::string::npos) continue;
    ASSERT_TRUE(parts.contains(file.path)) << file.path;
    EXPECT_EQ(entities.at(file.path).at("contentSize").get<std::string>(),
              std::to_string(file.size));
  }
  EXPECT_EQ(parts.size(), files + 2) << "frames of films a and d";
  EXPECT_EQ(entities.at("videos/c.webp").at("encodingFormat").get<std::string>(), "image/webp");
}

// Workflow Run Crate 0.5: the workflow is the main entity and the instrument of an action, which is
// mentioned; its objects are what was read, its results what was made.
TEST(ResearchCrate, TellsWhatWasMadeOfWhatByWhichManifest) {
  const test::MadeStudy study;
  const StudyContents contents = contents_of(study.folder());
  const auto entities = entities_of(crate_metadata(contents, payload_of(contents), {}));
  const json& root = entities.at("./");
  for (const char* profile :
       {"https://w3id.org/ro/wfrun/process/0.5", "https://w3id.org/ro/wfrun/workflow/0.5",
        "https://w3id.org/workflowhub/workflow-ro-crate/1.0"}) {
    EXPECT_TRUE(ids_in(root.at("conformsTo")).contains(profile)) << profile;
    EXPECT_EQ(entities.at(profile).at("@type").get<std::string>(), "CreativeWork");
  }
  const json& workflow = entities.at(root.at("mainEntity").at("@id").get<std::string>());
  EXPECT_EQ(workflow.at("@type"), json({"File", "SoftwareSourceCode", "ComputationalWorkflow"}));
  EXPECT_EQ(entities.at(workflow.at("programmingLanguage").at("@id").get<std::string>())
                .at("@type")
                .get<std::string>(),
            "ComputerLanguage");
  const json& run = entities.at(root.at("mentions").at("@id").get<std::string>());
  EXPECT_EQ(run.at("@type").get<std::string>(), "CreateAction");
  EXPECT_EQ(run.at("instrument").at("@id"), workflow.at("@id"));
  EXPECT_EQ(run.at("description").get<std::string>(), contents.command);
  EXPECT_TRUE(ids_in(run.at("object")).contains("inputs/my.recipes.yaml"));
  EXPECT_TRUE(ids_in(run.at("result")).contains("videos/b.mp4"));
  EXPECT_FALSE(ids_in(run.at("result")).contains("inputs/my.recipes.yaml"));
}

TEST(ResearchCrate, TellsOfRecordingsThatItDoesNotHold) {
  StudyContents contents;
  contents.study = "captured";
  contents.as_run = "inputs/as-run.yaml";
  contents.recordings = {{"captures/a walk.bvh", "12ab", "", true},
                         {"captures/held.bvh", "34cd", "AMASS licence", false},
                         {"captures/here.bvh", "56ef", "CC0-1.0", true}};
  const std::vector<PayloadFile> payload = {{"inputs/as-run.yaml", 3},
                                            {"recordings/captures/here.bvh", 5}};
  const auto entities = entities_of(crate_metadata(contents, payload, {}));
  const json& walk = entities.at("#recordings/captures/a%20walk.bvh");
  EXPECT_EQ(walk.at("identifier").get<std::string>(), "XXH3-128:12ab");
  EXPECT_FALSE(walk.contains("license"));
  EXPECT_EQ(entities.at("#recordings/captures/held.bvh").at("license").get<std::string>(),
            "AMASS licence");
  EXPECT_EQ(
      ids_in(entities.at("#run").at("object")),
      (std::set<std::string>{"#recordings/captures/a%20walk.bvh", "#recordings/captures/held.bvh",
                             "recordings/captures/here.bvh"}));
}

TEST(ResearchCrate, NamesLicencesByTheirAddresses) {
  StudyContents contents;
  contents.study = "tiny";
  contents.as_run = "inputs/as-run.yaml";
  const auto id_of = [&](const char* licence) {
    BagInfo info;
    info.license = licence;
    const auto entities = entities_of(crate_metadata(contents, {}, info));
    const std::string id = entities.at("./").at("license").at("@id").get<std::string>();
    EXPECT_EQ(entities.at(id).at("name").get<std::string>(), licence);
    return id;
  };
  EXPECT_EQ(id_of("CC0-1.0"), "https://spdx.org/licenses/CC0-1.0");
  EXPECT_EQ(id_of("https://example.org/terms"), "https://example.org/terms");
  EXPECT_EQ(id_of("only for teaching"), "#licence");
}

}  // namespace
}  // namespace mien::pipeline
