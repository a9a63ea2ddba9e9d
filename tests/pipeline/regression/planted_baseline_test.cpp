#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/planted_names.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/regression/approval.h"
#include "pipeline/regression/approved_study.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A baseline that a stranger wrote, deep in a folder with other things. What is done with it
/// changes nothing beside it.
class PlantedBaseline : public testing::Test {
 protected:
  PlantedBaseline() {
    for (const char* path : {"planted/stimulus.json", "b/stimulus.json", "thesis/thesis.tex"}) {
      make_folder((scratch_.path() / path).parent_path());
      write_file(scratch_.path() / path, "mine");
    }
    fs::copy(folder_ / "stimuli" / "blend", scratch_.path() / "thesis",
             fs::copy_options::recursive);
    // Whoever writes one by hand need not know its checksums.
    json baseline = json::parse(read_file(folder_ / "baseline.json"));
    baseline.erase("checksum");
    baseline.erase("sums");
    write_file(folder_ / "baseline.json", baseline.dump());
  }

  /// Approves what the baseline has and the study has not, which draws nothing.
  std::string approve_gone(const std::vector<std::string>& only) {
    try {
      approve(*now_, folder_, {.who = "me", .when = "now", .why = "", .only = only}, {}, inputs_,
              {.key_frames = 2, .threads = 2}, {}, {});
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  std::map<std::string, std::string> beside() const {
    return test::surroundings(scratch_.path(), folder_);
  }

  test::TemporaryFolder scratch_;
  test::TemporaryFolder store_;
  /// A folder in one that is made.
  static fs::path deep(const fs::path& folder) {
    make_folder(folder / "deep" / "er");
    return folder / "deep" / "er" / "study";
  }

  test::ChangedStudy study_ = test::approved_study().copied(deep(scratch_.path()));
  fs::path folder_ = study_.baseline.folder;
  std::unique_ptr<Rendition> now_ = test::rendition_of(study_, store_.path());
  std::map<std::string, Hash> inputs_ = hashes_of_inputs(now_->manifest());
};

TEST_F(PlantedBaseline, OfAStimulusCalledAsAFolderElsewhereRemovesNothing) {
  // The folder that the id leads to holds all that a stimulus has.
  const std::string id = fs::relative(scratch_.path() / "thesis", folder_ / "stimuli").string();
  json baseline = json::parse(read_file(folder_ / "baseline.json"));
  baseline["stimuli"].push_back(id);
  write_file(folder_ / "baseline.json", baseline.dump());
  const auto before = beside();
  for (const std::string& only : {id, std::string("blend")}) {
    const std::string said = approve_gone({only});
    EXPECT_NE(said.find("baseline.json: the name \"../"), std::string::npos) << said;
  }
  EXPECT_EQ(beside(), before);
}

TEST_F(PlantedBaseline, HasNoSumsOfFilesElsewhere) {
  json baseline = json::parse(read_file(folder_ / "baseline.json"));
  for (const std::string& name : test::planted_names(scratch_.path() / "thesis")) {
    baseline["sums"] = {{name, "0"}};
    // With its true checksum: whoever plants a name can reckon it.
    std::string text = baseline.dump(2);
    text.erase(text.rfind("\n}"));
    text += ",\n  ";
    text += "\"checksum\": \"" + hash_of(text) + "\"\n}\n";
    write_file(folder_ / "baseline.json", text);
    try {
      read_baseline(folder_);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("the path \""), std::string::npos) << error.what();
    }
  }
}

TEST_F(PlantedBaseline, WithANameInAnyFieldLeavesItsSurroundingsAlone) {
  const auto before = beside();
  int trials = 0, refused = 0;
  for (const fs::path& file :
       {folder_ / "baseline.json", folder_ / "stimuli" / "blend" / "stimulus.json"}) {
    const std::string text = read_file(file);
    const std::string other = read_file(folder_ / "baseline.json");
    const std::vector<std::string> names = test::planted_names(scratch_.path() / "thesis");
    test::each_planted(json::parse(text), names, [&](const json& planted, const std::string& at) {
      motion::write_in_place(file, planted.dump(-1, ' ', false, json::error_handler_t::replace));
      ++trials;
      try {
        check_files(read_baseline(folder_));
      } catch (const Error&) {
        ++refused;
      }
      if (trials % 5 == 0) approve_gone({"none", "../../../planted", "..", "blend/../../b"});
      EXPECT_TRUE(fs::exists(scratch_.path() / "thesis" / "thesis.tex")) << at;
      motion::write_in_place(folder_ / "baseline.json", other);
      motion::write_in_place(file, text);
    });
  }
  EXPECT_EQ(beside(), before);
  EXPECT_GT(refused, 50) << "of " << trials;
}

TEST_F(PlantedBaseline, WithLinksThatLeadOutIsNotApproved) {
  const fs::path elsewhere = scratch_.path() / "elsewhere";
  for (const char* name : {"stimuli", "editions", "baseline.json.next", "baseline.json"}) {
    fs::remove_all(elsewhere);
    if (fs::exists(folder_ / name))
      fs::rename(folder_ / name, elsewhere);
    else
      write_file(elsewhere, "mine");
    fs::create_symlink(elsewhere, folder_ / name);
    const auto before = beside();
    const std::string said = approve_gone({"none"});
    EXPECT_NE(said.find("link that leads out of its folder"), std::string::npos) << name << said;
    EXPECT_EQ(beside(), before) << name;
    fs::remove(folder_ / name);
    fs::rename(elsewhere, folder_ / name);
  }
  fs::remove(folder_ / "baseline.json.next");
  EXPECT_EQ(approve_gone({"none"}), "");
}

TEST_F(PlantedBaseline, KeepsAStimulusThatIsCalledLikeAnOldOne) {
  // "blend.old" was cleared away when "blend" was approved.
  json baseline = json::parse(read_file(folder_ / "baseline.json"));
  baseline["stimuli"].push_back("blend.old");
  fs::copy(folder_ / "stimuli" / "blend", folder_ / "stimuli" / "blend.old",
           fs::copy_options::recursive);
  json facts = json::parse(read_file(folder_ / "stimuli" / "blend.old" / "stimulus.json"));
  facts["id"] = "blend.old";
  write_file(folder_ / "stimuli" / "blend.old" / "stimulus.json", facts.dump());
  write_file(folder_ / "baseline.json", baseline.dump());
  EXPECT_EQ(approve_gone({"blend"}), "");
  EXPECT_NO_THROW(check_files(read_baseline(folder_)));
  EXPECT_TRUE(fs::exists(folder_ / "stimuli" / "blend.old" / "stimulus.json"));
}

}  // namespace
}  // namespace mien::pipeline
