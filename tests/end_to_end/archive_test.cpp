// What becomes of a finished study: verified, cleaned, packed, and unpacked by others' programs.

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"
#include "shared_set_up.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* tiny_manifest = R"(mien: 1
study: tiny
seed: 7
examples: {set: builtin:walks-10}
output: {size: [64, 48], fps: 8, cycles: 1, quality: draft, frames: png, video: [mp4], clips: [bvh]}
stimuli:
  - {id: a, weights: {normal: 1}}
  - {id: b, weights: {sad: 1}, output: {frames: none}}
)";

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void make_tiny(const fs::path& folder) {
  const fs::path manifest = folder / "tiny.yaml";
  std::ofstream(manifest) << tiny_manifest;
  must_run(mien_with({"run", manifest.string(), "--out", (folder / "out").string()}));
}

/// A study that was made, with a file of its owner.
class Archive : public testing::Test {
 protected:
  Archive() {
    fs::copy(shared_set_up("archive", make_tiny), scratch.path(), fs::copy_options::recursive);
    std::ofstream(study / "my notes.txt") << "mine";
  }

  Ended verify(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"verify", study.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_mien(arguments);
  }

  /// A command of a shell in the scratch folder.
  int shell(const std::string& command) const {
    return std::system(("cd '" + scratch.path().string() + "' && " + command).c_str());
  }

  const Scratch scratch;
  const fs::path study = scratch.path() / "out/tiny";
  const std::string manifest = (scratch.path() / "tiny.yaml").string();
};

TEST_F(Archive, IsVerifiedInWordsAndAsJson) {
  const Ended sound = verify();
  EXPECT_EQ(sound.code, 0) << sound.errors;
  EXPECT_TRUE(sound.output.starts_with("extra     my notes.txt\n" + study.string() + ": "))
      << sound.output;
  EXPECT_TRUE(says(sound.output, "decoded: 0 missing, 0 changed, 1 extra\n")) << sound.output;
  fs::remove(study / "clips/b.bvh");
  std::ofstream(study / "methods.md", std::ios::app) << " ";
  const Ended unsound = verify({"--json"});
  EXPECT_EQ(unsound.code, 1);
  const json found = json::parse(unsound.output);
  EXPECT_FALSE(found["sound"].get<bool>());
  EXPECT_EQ(found["missing"][0]["path"], "clips/b.bvh");
  EXPECT_EQ(found["changed"][0]["path"], "methods.md");
  EXPECT_EQ(found["extra"][0]["path"], "my notes.txt");
  EXPECT_EQ(run_mien({"verify", (scratch.path() / "none").string()}).code, 2);
}

TEST_F(Archive, HasFramesThatAreDrawnAgain) {
  const Ended drawn = verify({"--rerender", "6"});
  EXPECT_EQ(drawn.code, 0) << drawn.output << drawn.errors;
  EXPECT_TRUE(says(drawn.output, "6 of 6 rerendered frames agree (seed 7)\n")) << drawn.output;
  EXPECT_EQ(drawn.output, verify({"--rerender", "6"}).output);
  EXPECT_NE(drawn.output, verify({"--rerender", "6", "--seed", "8"}).output);
  const std::string first = text_of(study / "frames/a/00000.png");
  for (const auto& frame : fs::directory_iterator(study / "frames/a"))
    std::ofstream(frame.path(), std::ios::binary) << first;
  const Ended other = verify({"--rerender", "100", "--json"});
  EXPECT_EQ(other.code, 1);
  int agree = 0;
  const json result = json::parse(other.output);
  for (const json& frame : result["rerendered"]["frames"])
    agree += frame["film"] == "a" && frame["agrees"] ? 1 : 0;
  EXPECT_EQ(agree, 1);  // 00000.png is itself
}

TEST_F(Archive, IsCleanedOfWhatIsNotKept) {
  const std::string out = (scratch.path() / "out").string();
  const Ended planned =
      run_mien({"clean", study.string(), "--keep", "videos,metrics", "--dry-run"});
  EXPECT_EQ(planned.code, 0) << planned.errors;
  EXPECT_TRUE(says(planned.output, "would remove frames/a, ")) << planned.output;
  EXPECT_TRUE(fs::exists(study / "frames/a"));
  const json done = json::parse(
      run_mien({"clean", manifest, "--out", out, "--keep", "videos,metrics", "--json"}).output);
  EXPECT_EQ(done["removed"].size(), 5u) << done;
  EXPECT_FALSE(fs::exists(study / "frames"));
  const Ended verified = verify({"--rerender", "4"});
  EXPECT_EQ(verified.code, 0) << verified.output << verified.errors;
  EXPECT_TRUE(says(verified.output, "not kept  clips: 2 artifacts\n")) << verified.output;
  EXPECT_TRUE(says(verified.output, "against videos/a.mp4: PSNR ")) << verified.output;
  EXPECT_EQ(run_mien({"clean", study.string()}).code, 2);
  EXPECT_EQ(run_mien({"clean", study.string(), "--keep", "vidos"}).code, 2);
}

TEST_F(Archive, SaysThatTheReportHasDeadLinksThen) {
  const std::vector<std::string> words = {"clean", study.string(), "--keep", "metrics"};
  std::vector<std::string> dry = words;
  dry.push_back("--dry-run");
  const Ended planned = run_mien(dry);
  EXPECT_TRUE(says(planned.output, "of its links would be broken")) << planned.output;
  const Ended done = run_mien(words);
  EXPECT_TRUE(says(done.output, "of its links are broken")) << done.output;
  EXPECT_FALSE(says(run_mien(words).output, "broken"));
}

TEST_F(Archive, IsNotPackedOverWhatIsThere) {
  const std::string archive = (scratch.path() / "a.tar").string();
  std::ofstream(archive) << "somebody's";
  const Ended refused = run_mien({"pack", study.string(), "-o", archive});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(says(refused.errors, "a.tar: exists already")) << refused.errors;
  EXPECT_EQ(text_of(archive), "somebody's");
  const Ended forced = run_mien({"pack", study.string(), "-o", archive, "--force", "--license",
                                 "CC-BY-4.0", "--contact-name", "A. Walker"});
  EXPECT_EQ(forced.code, 0) << forced.errors;
  EXPECT_TRUE(says(text_of(archive), "Contact-Name: A. Walker\n"));
  EXPECT_TRUE(says(text_of(archive), "License: CC-BY-4.0\n"));
}

TEST_F(Archive, IsABagThatOthersUnpackAndCheck) {
  const auto packed = [&](const std::string& name) {
    const Ended ended = run_mien({"pack", study.string(), "-o", (scratch.path() / name).string()});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_TRUE(says(ended.output, "not made by mien: my notes.txt\n")) << ended.output;
    return text_of(scratch.path() / name);
  };
  for (const std::string name : {"a.tar", "a.tar.gz", "a.tar.zst"}) {
    const std::string bytes = packed(name);
    EXPECT_EQ(bytes, packed("again-" + name)) << name;
    ASSERT_EQ(shell("rm -rf tiny && tar xf " + name), 0) << name;
    EXPECT_EQ(shell("cd tiny && sha256sum --quiet --strict -c manifest-sha256.txt "
                    "tagmanifest-sha256.txt"),
              0);
    EXPECT_EQ(shell("diff -r -x .mien -x ro-crate-metadata.json out/tiny tiny/data"), 0);
  }
  const std::string bag = (scratch.path() / "tiny").string();
  EXPECT_EQ(text_of(bag + "/bagit.txt"),
            "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n");
  const Ended verified = run_mien({"verify", bag, "--rerender", "2"});
  EXPECT_EQ(verified.code, 0) << verified.output << verified.errors;
  // What it adds is no part of the study, which can be packed again.
  EXPECT_FALSE(says(verified.output, "ro-crate")) << verified.output;
  const std::string again = (scratch.path() / "from-the-bag.tar").string();
  const Ended packed_again = run_mien({"pack", bag, "-o", again});
  EXPECT_EQ(packed_again.code, 0) << packed_again.errors;
  EXPECT_EQ(text_of(again), text_of(scratch.path() / "a.tar"));
}

TEST_F(Archive, HasADateThatIsOne) {
  const std::string archive = (scratch.path() / "a.tar").string();
  for (const char* date : {"2026-02-30", "30.11.2026", "2026-11", "2026-11-30 ", "2026-1-030",
                           "2026- 1-03", " 026-11-30", "+026-11-30", "2026-00-10"}) {
    const Ended refused = run_mien({"pack", study.string(), "-o", archive, "--published", date});
    EXPECT_EQ(refused.code, 2) << date;
    EXPECT_TRUE(says(refused.errors, "is not a date")) << refused.errors;
    EXPECT_FALSE(fs::exists(archive)) << date;
  }
}

TEST_F(Archive, HoldsStimuliForABidsDataset) {
  const std::string archive = (scratch.path() / "a.tar").string();
  const Ended packed = run_mien({"pack", study.string(), "-o", archive, "--bids", "--license",
                                 "CC0-1.0", "--published", "2026-11-30"});
  ASSERT_EQ(packed.code, 0) << packed.errors;
  EXPECT_TRUE(says(packed.errors, "before publication, state --organization")) << packed.errors;
  ASSERT_EQ(shell("rm -rf tiny && tar xf a.tar && cd tiny && sha256sum --quiet --strict -c "
                  "manifest-sha256.txt"),
            0);
  const Ended verified = run_mien({"verify", (scratch.path() / "tiny").string()});
  EXPECT_EQ(verified.code, 0) << verified.errors;
  EXPECT_FALSE(says(verified.output, "stimuli/")) << verified.output;
  const fs::path stimuli = scratch.path() / "tiny/data/stimuli";
  int media = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(stimuli))
    media += entry.path().extension() == ".mp4" ? 1 : 0;
  EXPECT_GT(media, 0);
  // The crate describes them, too.
  EXPECT_TRUE(says(text_of(scratch.path() / "tiny/data/ro-crate-metadata.json"),
                   "\"@id\": \"stimuli/stimuli.tsv\""));
}

/// What is packed, held against validators of others.
class ArchiveStandards : public Archive {
 protected:
  ArchiveStandards() {
    must_run(mien_with({"pack", study.string(), "-o", (scratch.path() / "a.tar").string(), "--bids",
                        "--license", "CC0-1.0", "--organization", "University of Somewhere",
                        "--published", "2026-11-30"}));
    EXPECT_EQ(shell("tar xf a.tar"), 0);
  }

  const fs::path data = scratch.path() / "tiny/data";
};

TEST_F(ArchiveStandards, AreMetByTheResearchCrate) {
  const fs::path tests = fs::path(MIEN_PROGRAM).parent_path() / "pages/work";
  if (!fs::exists(tests / "node_modules/ro-crate"))
    GTEST_SKIP() << "no ro-crate in build/release/pages/work: ./mien test brings it";
  const auto errors_in = [&](const fs::path& crate) {
    const Ended checked =
        run_program({"node", (tests / "tests/research_crate.mjs").string(), crate.string()});
    EXPECT_EQ(checked.code, 0) << checked.errors;
    std::vector<std::string> faults;
    int found = 0;
    const json results = json::parse(checked.output);
    for (const json& result : results) {
      ++found;
      if (result.at("status").get<std::string>() != "success")
        faults.push_back(result.at("id").get<std::string>());
    }
    EXPECT_GE(found, 9);
    return faults;
  };
  const fs::path crate = data / "ro-crate-metadata.json";
  EXPECT_EQ(errors_in(crate), std::vector<std::string>());
  json lacking = json::parse(text_of(crate));
  for (json& entity : lacking.at("@graph")) entity.erase("license");
  std::ofstream(scratch.path() / "lacking.json") << lacking.dump();
  EXPECT_EQ(errors_in(scratch.path() / "lacking.json"),
            std::vector<std::string>{"licenseRequired"});
}

// Of the proposal for stimuli, Debian's validator knows the folder and not yet the names in it.
TEST_F(ArchiveStandards, AreMetByTheStimuliForBids) {
  const std::string script =
      "import os, sys\n"
      "from bids_validator import BIDSValidator\n"
      "names = ['/stimuli/' + name for name in os.listdir('stimuli')] + ['/stimulus/a.mp4']\n"
      "print(len(names), [name for name in names if not BIDSValidator().is_bids(name)])\n";
  if (run_program({"/usr/bin/python3", "-c", "import bids_validator"}).code != 0)
    GTEST_SKIP() << "no python3-bids-validator here";
  const Ended checked = run_program(
      {"sh", "-c", "cd '" + data.string() + "' && /usr/bin/python3 -c \"" + script + "\""});
  EXPECT_EQ(checked.output, "7 ['/stimulus/a.mp4']\n") << checked.errors;
}

/// A study of two recordings, of which one must not be shared, in an own folder.
class ArchiveOfRecordings : public Archive {
 protected:
  ArchiveOfRecordings() {
    fs::create_directories(here / "captures");
    fs::create_directories(here / "amass");
    fs::copy(study / "clips/a.bvh", here / "captures/free.bvh");
    fs::copy(study / "clips/b.bvh", here / "amass/walk.bvh");
    std::ofstream(here / "m.yaml") << R"(mien: 1
study: two
output: {size: [64, 48], fps: 8, cycles: 1, quality: draft, frames: none, video: [gif], clips: [bvh]}
stimuli:
  - {id: free, clip: {file: captures/free.bvh, licence: CC0, source: example.org/walks}}
  - {id: bound, clip: {file: amass/walk.bvh, licence: {name: AMASS licence, share: false}, source: amass.is.tue.mpg.de}}
  - {id: changed, clip: amass/walk.bvh, modify: {tempo: 0.9}}
)";
    must_run(mien_with({"run", (here / "m.yaml").string(), "--out", (here / "out").string()}));
  }

  /// Packs the study with these options and unpacks it elsewhere.
  Ended pack(const std::vector<std::string>& options) const {
    std::vector<std::string> words = {"pack", (here / "out/two").string(), "--force", "-o",
                                      (here / "two.tar").string()};
    words.insert(words.end(), options.begin(), options.end());
    const Ended ended = run_mien(words);
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(shell("rm -rf far && mkdir -p far/away && tar xf mine/two.tar -C far/away && cd "
                    "far/away/two && sha256sum --quiet --strict -c manifest-sha256.txt "
                    "tagmanifest-sha256.txt"),
              0);
    return ended;
  }
  bool is_packed(const std::string& path) const { return fs::exists(bag / "data" / path); }
  Ended verify_bag() const { return run_mien({"verify", bag.string()}); }
  Ended run_again() const {
    return run_mien({"run", (bag / "data/provenance.json").string(), "--out",
                     (scratch.path() / "again").string()});
  }

  const fs::path here = scratch.path() / "mine";
  const fs::path bag = scratch.path() / "far/away/two";
};

TEST_F(ArchiveOfRecordings, LeavesOutWhatMustNotBeShared) {
  const Ended packed = pack({});
  for (const char* line : {"left out  amass/walk.bvh: licence AMASS licence\n",
                           "left out  clips/bound.bvh: licence AMASS licence\n",
                           "left out  clips/changed.bvh: licence AMASS licence\n"})
    EXPECT_TRUE(says(packed.output, line)) << packed.output;
  EXPECT_FALSE(says(packed.output, "free")) << packed.output;
  EXPECT_TRUE(says(text_of(bag / "bag-info.txt"),
                   "Left-Out: 1 recording and 2 motion files, which must not be shared (licence "
                   "AMASS licence)"))
      << text_of(bag / "bag-info.txt");
  EXPECT_TRUE(is_packed("clips/free.bvh"));
  EXPECT_TRUE(is_packed("videos/bound.gif"));
  EXPECT_FALSE(is_packed("clips/bound.bvh"));
  EXPECT_FALSE(is_packed("clips/changed.bvh"));
  EXPECT_FALSE(is_packed("recordings"));
  const Ended verified = verify_bag();
  EXPECT_EQ(verified.code, 0) << verified.output;
  EXPECT_TRUE(says(verified.output, "left out  amass/walk.bvh: licence AMASS licence\n"))
      << verified.output;
  EXPECT_TRUE(says(verified.output, "0 missing, 0 changed, 3 left out\n")) << verified.output;
  EXPECT_TRUE(says(verified.output, "(1 elsewhere, not checked)")) << verified.output;
  fs::remove(bag / "data/clips/free.bvh");
  const Ended damaged = verify_bag();
  EXPECT_EQ(damaged.code, 1);
  EXPECT_TRUE(says(damaged.output, "missing   clips/free.bvh\n")) << damaged.output;
}

TEST_F(ArchiveOfRecordings, LeavesOutWhatAnEarlierRunMadeOfThem) {
  std::string text = text_of(here / "m.yaml");
  text.replace(text.find("clips: [bvh]"), 12, "clips: [glb]");
  std::ofstream(here / "m.yaml") << text;
  must_run(mien_with({"run", (here / "m.yaml").string(), "--out", (here / "out").string()}));
  std::ofstream(here / "out/two/50 %.txt") << "mine";
  const Ended packed =
      run_mien({"pack", (here / "out/two").string(), "-o", (here / "two.tar").string(), "--json"});
  EXPECT_EQ(packed.code, 0) << packed.errors;
  EXPECT_TRUE(says(packed.errors, "warning: data/50 %.txt: BagIt encodes %")) << packed.errors;
  EXPECT_EQ(json::parse(packed.output)["stale"],
            (json{"clips/bound.bvh", "clips/changed.bvh", "clips/free.bvh"}));
  EXPECT_FALSE(says(text_of(here / "two.tar"), "bound.bvh"));
}

TEST_F(ArchiveOfRecordings, HoldsTheOthersIfRequested) {
  pack({"--recordings"});
  EXPECT_EQ(text_of(bag / "data/recordings/captures/free.bvh"),
            text_of(here / "captures/free.bvh"));
  EXPECT_FALSE(is_packed("recordings/amass"));
  const Ended verified = verify_bag();
  EXPECT_EQ(verified.code, 0) << verified.output;
  EXPECT_FALSE(says(verified.output, "elsewhere")) << verified.output;
  // What is missing for another run, and where it belongs, is stated once.
  const fs::path place = bag / "data/recordings/amass/walk.bvh";
  const json record = json::parse(text_of(bag / "data/provenance.json"));
  const Ended refused = run_again();
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.errors,
            (bag / "data/provenance.json").string() + ": the recording \"amass/walk.bvh\" (hash " +
                record["recordings"][0]["hash"].get<std::string>() +
                ", licence \"AMASS licence\", not to be shared) is missing; get it from "
                "amass.is.tue.mpg.de and save it as " +
                place.string() + "\n");
  fs::create_directories(place.parent_path());
  fs::copy(here / "amass/walk.bvh", place);
  const Ended again = run_again();
  EXPECT_EQ(again.code, 0) << again.errors;
  EXPECT_EQ(text_of(scratch.path() / "again/two/clips/bound.bvh"),
            text_of(here / "out/two/clips/bound.bvh"));
  EXPECT_EQ(json::parse(text_of(scratch.path() / "again/two/provenance.json"))["recordings"],
            record["recordings"]);
  std::ofstream(bag / "data/recordings/captures/free.bvh", std::ios::app) << " ";
  EXPECT_EQ(verify_bag().code, 1);
}

TEST_F(ArchiveOfRecordings, HoldsAllOnRequest) {
  const Ended packed = pack({"--recordings", "--restricted"});
  EXPECT_FALSE(says(packed.output, "left out")) << packed.output;
  EXPECT_TRUE(is_packed("recordings/amass/walk.bvh"));
  EXPECT_TRUE(is_packed("clips/bound.bvh"));
  EXPECT_EQ(verify_bag().code, 0);
  fs::rename(here, scratch.path() / "gone");
  const Ended again = run_again();
  EXPECT_EQ(again.code, 0) << again.errors;
  // From an unpacked archive, what must not be shared is left out again.
  const Ended second = run_mien(
      {"pack", bag.string(), "--recordings", "-o", (scratch.path() / "second.tar").string()});
  EXPECT_EQ(second.code, 0) << second.errors;
  EXPECT_TRUE(says(second.output, "left out  clips/bound.bvh")) << second.output;
  ASSERT_EQ(shell("mkdir other && tar xf second.tar -C other"), 0);
  const fs::path data = scratch.path() / "other/two/data";
  EXPECT_TRUE(fs::exists(data / "recordings/captures/free.bvh"));
  EXPECT_FALSE(fs::exists(data / "recordings/amass"));
  EXPECT_FALSE(fs::exists(data / "clips/bound.bvh"));
}

TEST_F(ArchiveOfRecordings, IsNotExcusedByAListOfItsOwn) {
  pack({});
  json list = json::parse(text_of(bag / "data/recordings.json"));
  list["left_out_files"].push_back("clips/free.bvh");
  std::ofstream(bag / "data/recordings.json") << list.dump();
  fs::remove(bag / "data/clips/free.bvh");
  const Ended verified = verify_bag();
  EXPECT_EQ(verified.code, 1);
  EXPECT_TRUE(says(verified.output, "missing   clips/free.bvh\n")) << verified.output;
}

TEST_F(Archive, IsNotPackedWhenItIsNotWhatItWas) {
  std::ofstream(study / "clips/a.bvh", std::ios::app) << " ";
  const fs::path archive = scratch.path() / "a.tar.zst";
  const Ended refused = run_mien({"pack", study.string(), "-o", archive.string()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.output, "");
  EXPECT_TRUE(says(refused.errors, "changed   clips/a.bvh: ")) << refused.errors;
  EXPECT_TRUE(says(refused.errors, "is not packed; mien run ")) << refused.errors;
  EXPECT_FALSE(fs::exists(archive));
  const Ended ending = run_mien({"pack", study.string(), "-o", "a.zip"});
  EXPECT_EQ(ending.code, 2);
  EXPECT_TRUE(says(ending.errors, "use the extension .tar.zst, .tar.gz or .tar")) << ending.errors;
}

}  // namespace
}  // namespace mien::test
