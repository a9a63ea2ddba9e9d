#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = entry.is_directory() ? "" : text_of(entry.path());
  return files;
}

/// A walk in a folder of its own.
class Convert : public testing::Test {
 protected:
  Convert() {
    EXPECT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        "normal=1", "--cycles", "2", "-o", at("walk.bvh")})
                  .code,
              0);
  }

  std::string at(const std::string& name) const { return (scratch_.path() / name).string(); }
  Ended convert(const std::string& in, const std::string& out,
                std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"motion", "convert", at(in), at(out)});
    return run_mien(more);
  }
  json info(const std::string& name) const {
    return json::parse(run_mien({"motion", "info", at(name), "--json"}).output);
  }

  Scratch scratch_;
};

const char* const bids = "sub-01_task-walk_tracksys-joints_motion.tsv";

TEST_F(Convert, WritesJointsInEveryFormatOfPointsAndBodiesFromThem) {
  const json walk = info("walk.bvh");
  for (const std::string name : {"p.trc", "p.csv", "p.npy", bids}) {
    const Ended written = convert("walk.bvh", name);
    ASSERT_EQ(written.code, 0) << written.errors;
    EXPECT_EQ(written.output.substr(0, written.output.find('\n')),
              at(name) + ": " + walk["frames"].dump() + " frames, 21 joints");
    const json points = info(name);
    EXPECT_EQ(points["frames"], walk["frames"]) << name;
    EXPECT_NEAR(points["fps"].get<double>(), walk["fps"].get<double>(), 1e-3) << name;
    EXPECT_EQ(points["up"], "+Y") << name;
    EXPECT_EQ(points["recorded"]["points"].size(), 21u) << name;
    EXPECT_LT(points["recorded"]["fit_residual_mm"].get<double>(), 5.0) << name;
    const Ended fitted = convert(name, "again.bvh");
    ASSERT_EQ(fitted.code, 0) << fitted.errors;
    EXPECT_NE(fitted.output.find("21 joints of a body fitted to 21 points"), std::string::npos)
        << fitted.output;
    const json distance = json::parse(
        run_mien({"motion", "compare", at("walk.bvh"), at("again.bvh"), "--json"}).output);
    EXPECT_LT(distance["D"].get<double>(), 0.01) << name;
  }
}

TEST_F(Convert, KeepsRecordedPointsThroughEveryPairOfFormats) {
  std::string gaps = "frame,time_s,point,x_m,y_m,z_m\n";
  for (int frame = 0; frame < 6; ++frame)
    for (const char* point : {"LASI", "b c", "HEAD"}) {
      const bool is_missing = frame % 3 == 1 && point[0] == 'b';
      char row[96];
      std::snprintf(row, sizeof row, "%d,%g,%s,%s\n", frame, frame * 0.02, point,
                    is_missing ? ",," : "0.1234,1.25,-0.5");
      gaps += row;
    }
  scratch_.write("first.csv", gaps);
  const std::vector<std::string> names = {"a.csv", "a.trc", "a.npy", bids};
  const Ended first = convert("first.csv", "a.csv");
  ASSERT_EQ(first.code, 0) << first.errors;
  EXPECT_NE(first.output.find("6 frames, 3 points, as recorded"), std::string::npos)
      << first.output;
  EXPECT_EQ(text_of(at("a.csv")), gaps);
  for (const std::string& through : names) {
    if (through != "a.csv") {
      ASSERT_EQ(convert("a.csv", through).code, 0);
    }
    for (const std::string& last : names) {
      const std::string again = last == bids ? last : "c" + last.substr(1);
      if (through == last && last == bids) continue;  // would be its own input
      ASSERT_EQ(convert(through, again).code, 0) << through << " " << last;
      ASSERT_EQ(convert(again, "end.csv").code, 0) << through << " " << last;
      EXPECT_EQ(text_of(at("end.csv")), gaps) << through << " " << last;
    }
  }
}

TEST_F(Convert, WritesRotationsInTheLayoutOfAmass) {
  ASSERT_EQ(convert("walk.bvh", "walk.npz").code, 0);
  const json read = info("walk.npz");
  EXPECT_EQ(read["up"], "+Z");
  EXPECT_EQ(read["frames"], info("walk.bvh")["frames"]);
  ASSERT_EQ(convert("walk.npz", "again.bvh").code, 0);
  const json distance = json::parse(
      run_mien({"motion", "compare", at("walk.bvh"), at("again.bvh"), "--json"}).output);
  EXPECT_LT(distance["D"].get<double>(), 0.02);  // bone lengths are not part of the format
}

TEST_F(Convert, TakesSubjectRateAndBody) {
  scratch_.write("two.csv",
                 "frame,person,point,x,y,z\n1,A,a,1,2,3\n1,B,b,4,5,6\n2,A,a,1,2,3\n2,B,b,4,5,6\n");
  const Ended chosen = convert("two.csv", "b.csv", {"--subject", "B", "--recorded-fps", "40"});
  ASSERT_EQ(chosen.code, 0) << chosen.errors;
  EXPECT_EQ(text_of(at("b.csv")), "frame,time_s,point,x,y,z\n0,0,b,4,5,6\n1,0.025,b,4,5,6\n");
  const json description = json::parse(text_of(at("b.csv.json")));
  EXPECT_EQ(description["frames_per_second"], 40.0);
  EXPECT_EQ(description["points"], json({"b"}));
  ASSERT_EQ(convert("walk.bvh", "walk.trc").code, 0);
  const Ended fitted = convert("walk.trc", "body.csv", {"--body"});
  ASSERT_EQ(fitted.code, 0) << fitted.errors;
  EXPECT_NE(fitted.output.find("of a body fitted to 21 points"), std::string::npos);
  EXPECT_EQ(json::parse(text_of(at("body.csv.json")))["axes"], "right-handed, +Y up");
  EXPECT_EQ(convert("walk.bvh", "x.trc", {"--take", "Run"}).code, 2);
}

TEST_F(Convert, WritesPointsWhoseNamesInfoLists) {
  ASSERT_EQ(convert("walk.bvh", "walk.csv").code, 0);
  const std::string info = run_mien({"motion", "info", at("walk.csv")}).output;
  EXPECT_NE(info.find("\n  Pelvis, Spine,"), std::string::npos) << info;
  EXPECT_NE(info.find(" and 9 more (all with --json)\n"), std::string::npos) << info;
}

TEST_F(Convert, RefusesBeforeAnythingIsWritten) {
  ASSERT_EQ(convert("walk.bvh", "walk.csv").code, 0);
  scratch_.write("dots.csv", "frame,time_s,point,x_m,y_m,z_m\n0,0,p,1,2,3\n1,0.1,p,1,2,3\n");
  ASSERT_EQ(convert("walk.bvh", "WALK.NPY").code, 0);
  fs::create_directory(at("taken.csv.json"));
  const auto before = files_in(scratch_.path());
  struct Request {
    std::string in, out, said;
    int code = 2;
  };
  for (const Request& request :
       std::vector<Request>{{"walk.bvh", "x.fbx", "use BVH (.bvh), glTF (.glb), TRC (.trc)"},
                            {"walk.bvh", "x.c3d", "is not a motion file that can be written"},
                            {"walk.bvh", "x.csv.gz", "compressed files are only read"},
                            {"walk.bvh", "x_motion.tsv", "is not a name of motion in BIDS"},
                            {"walk.csv", "walk.csv", "is the input file"},
                            {"WALK.NPY", "WALK.npy", "WALK.npy.json: is the input file"},
                            {"dots.csv", "x.bvh", "its points cannot be fitted to a body"},
                            {"walk.bvh", "taken.csv", "cannot be written (Is a directory)", 1}}) {
    const Ended ended = convert(request.in, request.out);
    EXPECT_EQ(ended.code, request.code) << request.out << ": " << ended.errors;
    EXPECT_NE(ended.errors.find(request.said), std::string::npos) << ended.errors;
    EXPECT_EQ(ended.errors.find('\n'), ended.errors.size() - 1) << ended.errors;
    EXPECT_EQ(files_in(scratch_.path()), before) << request.out;
  }
}

/// What the options for further files would write over.
TEST_F(Convert, NoCommandWritesOverWhatItReads) {
  ASSERT_EQ(convert("walk.bvh", "walk.csv").code, 0);
  const std::string study = scratch_
                                .write("study.yaml",
                                       "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\n"
                                       "stimuli: [{id: a, weights: {normal: 1}}]\n")
                                .string();
  scratch_.write("words.csv",
                 "participant,language,motion,verb,modifier1\n1,suomi,a,kävelee,hitaasti\n");
  scratch_.write("my.set.yaml", "background: \"#101010\"\n");
  fs::create_directory(at("captures"));
  fs::copy_file(at("walk.bvh"), at("captures/walk.bvh"));
  scratch_.write("model.npz", "a model");
  fs::create_directory(at("targets"));
  scratch_.write("targets/targets.csv", "mine\n");
  const auto before = files_in(scratch_.path());
  struct Request {
    std::vector<std::string> words;
    std::string said;
  };
  for (const Request& request : std::vector<Request>{
           {{"render", at("walk.bvh"), "--figure", "point-light", "-o", at("x.png"), "--dots",
             at("walk.bvh")},
            "walk.bvh: is the input file"},
           {{"render", at("walk.csv"), "--figure", "markers", "-o", at("x.png"), "--dots",
             at("walk.csv")},
            "walk.csv: is the input file"},
           {{"render", at("walk.bvh"), "--figure", "point-light", "--scene", at("my.set.yaml"),
             "-o", at("x.png"), "--dots", at("my.set.yaml")},
            "my.set.yaml: is the input file"},
           {{"render", at("walk.bvh"), "--figure", "point-light", "-o", at("x.png"), "--dots",
             at("./x.png")},
            "x.png: would be written twice"},
           {{"motion", "blend", "--examples", at("captures"), "--weights", "walk=1", "-o",
             at("captures/walk.bvh")},
            "walk.bvh: is the input file"},
           {{"motion", "convert", at("walk.npz"), at("model.npz"), "--body-model", at("model.npz")},
            "model.npz: is the input file"},
           {{"motion", "modify", at("walk.npz"), "sad", at("model.npz"), "--body-model",
             at("model.npz")},
            "model.npz: is the input file"},
           {{"farm", "export", study, "--format", "openjd", "-o", study, "--out", at("out")},
            "study.yaml: is the input file"},
           {{"study", "words", at("words.csv"), "--lexicon",
             MIEN_SOURCE_DIR "/manifests/walking-words.scales.yaml", "-o", at("words.csv")},
            "words.csv: is the input file"},
           {{"study", "targets", "--examples", "builtin:walks-10", "-o", at("targets")},
            "targets.csv: exists already and is not an earlier table of this kind"}}) {
    const Ended ended = run_mien(request.words);
    EXPECT_EQ(ended.code, 2) << ended.output << ended.errors;
    EXPECT_NE(ended.errors.find(request.said), std::string::npos) << ended.errors;
    EXPECT_EQ(files_in(scratch_.path()), before) << request.said;
  }
}

TEST(Clips, OfEveryFormatAreMadeVerifiedAndTheSameAgain) {
  const Scratch scratch;
  const fs::path manifest = scratch.write(
      "m.yaml",
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: simulated}\n"
      "output: {size: [32, 24], fps: 12.5, cycles: 1, quality: draft, video: [], frames: none, "
      "clips: [bvh, glb, trc, npz, npy, csv]}\n"
      "stimuli:\n  - {id: a, weights: {normal: 1}}\n  - {id: b, weights: {sad: 1}}\n");
  const fs::path one = scratch.path() / "one";
  const fs::path two = scratch.path() / "two";
  const Ended made = run_mien({"run", manifest.string(), "--out", one.string()});
  ASSERT_EQ(made.code, 0) << made.errors;
  ASSERT_EQ(run_mien({"run", manifest.string(), "--out", two.string()}).code, 0);
  const fs::path study = one / "s";
  const fs::path clips = study / "clips";
  const auto files = files_in(clips);
  std::string names;
  for (const auto& [name, bytes] : files) names += name + " ";
  EXPECT_EQ(names,
            "a.bvh a.csv a.csv.json a.glb a.npy a.npy.json a.npz a.trc "
            "b.bvh b.csv b.csv.json b.glb b.npy b.npy.json b.npz b.trc ");
  EXPECT_EQ(files, files_in(two / "s" / "clips"));
  const std::string provenance = text_of(study / "provenance.json");
  for (const auto& [name, bytes] : files)
    EXPECT_NE(provenance.find("clips/" + name), std::string::npos) << name;
  const Ended verified = run_mien({"verify", study.string()});
  EXPECT_EQ(verified.code, 0) << verified.output << verified.errors;
  std::ofstream(clips / "a.csv.json", std::ios::app) << " ";
  EXPECT_EQ(run_mien({"verify", study.string()}).code, 1);
  fs::remove(clips / "a.csv.json");  // the table is whole again after a run
  ASSERT_EQ(run_mien({"run", manifest.string(), "--out", one.string()}).code, 0);
  EXPECT_EQ(files_in(clips), files);
  const fs::path archive = scratch.path() / "s.tar";
  const Ended packed = run_mien({"pack", study.string(), "-o", archive.string()});
  ASSERT_EQ(packed.code, 0) << packed.errors;
  EXPECT_NE(text_of(archive).find("clips/a.csv.json"), std::string::npos);
  const Ended cleaned = run_mien({"clean", study.string(), "--keep", "metrics"});
  EXPECT_EQ(cleaned.code, 0) << cleaned.errors;
  EXPECT_FALSE(fs::exists(clips));
}

}  // namespace
}  // namespace mien::test
