#include "pipeline/tasks/stale_artifacts.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class StaleTest : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";

  static TaskGraph graph_of(const std::vector<std::string>& products) {
    TaskGraph graph;
    for (const std::string& path : products) {
      Task task;
      task.id = path;
      task.products.push_back({path, {}});
      graph.add(std::move(task));
    }
    return graph;
  }

  static void put(Store& store, const std::string& path) {
    store.put(
        path, "key", [&](const fs::path& file) { write_file(file, path); }, [](const fs::path&) {});
  }

  static void put_frames(Store& store, const std::string& path) {
    const auto frames = store.frames(path, "key");
    for (const char* name : {"0.png", "1.png"}) {
      frames->put(
          name, [](const fs::path& file) { write_file(file, "frame"); }, [](const fs::path&) {});
    }
    frames->publish({"0.png", "1.png"});
  }
};

TEST_F(StaleTest, IsWhatHasAReceiptAndNoTask) {
  Store store(folder);
  for (const char* path : {"videos/a.mp4", "videos/old.mp4", ".mien/motions/old.json", "all.json"})
    put(store, path);
  put_frames(store, "frames/old");
  write_file(folder / "videos/notes.txt", "mine");
  const std::vector<Receipt> stale =
      stale_artifacts(folder, graph_of({"videos/a.mp4", "videos/b.mp4"}), {"all.json"});
  ASSERT_EQ(stale.size(), 3u);
  EXPECT_EQ(stale[0].path, ".mien/motions/old.json");
  EXPECT_EQ(shown_paths(stale), (std::vector<std::string>{"frames/old", "videos/old.mp4"}));
  EXPECT_TRUE(stale_artifacts(temporary.path() / "nowhere", graph_of({}), {}).empty());
}

TEST_F(StaleTest, IsRemovedWithItsReceiptAndNothingElse) {
  Store store(folder);
  for (const char* path : {"videos/a.mp4", "clips/old.bvh", "videos/old.mp4"}) put(store, path);
  put_frames(store, "frames/old");
  write_file(folder / "videos/notes.txt", "mine");
  const TaskGraph graph = graph_of({"videos/a.mp4"});
  for (const Receipt& artifact : stale_artifacts(folder, graph, {}))
    EXPECT_TRUE(remove_artifact(store, artifact)) << artifact.path;
  EXPECT_TRUE(stale_artifacts(folder, graph, {}).empty());
  EXPECT_FALSE(fs::exists(folder / "clips"));
  EXPECT_FALSE(fs::exists(folder / "frames"));
  EXPECT_FALSE(fs::exists(folder / "videos/old.mp4"));
  EXPECT_TRUE(fs::exists(folder / "videos/notes.txt"));
  EXPECT_TRUE(store.find("videos/a.mp4", "key"));
}

TEST_F(StaleTest, StaysWhereSomebodyHasChangedIt) {
  Store store(folder);
  put(store, "videos/old.mp4");
  put_frames(store, "frames/old");
  write_file(folder / "videos/old.mp4", "cut by hand");
  write_file(folder / "frames/old/1.png", "retouched");
  for (const Receipt& artifact : stale_artifacts(folder, graph_of({}), {}))
    EXPECT_FALSE(remove_artifact(store, artifact)) << artifact.path;
  EXPECT_EQ(read_file(folder / "videos/old.mp4"), "cut by hand");
  EXPECT_TRUE(fs::exists(folder / "frames/old/0.png"));
  fs::remove(folder / "videos/old.mp4");
  EXPECT_TRUE(remove_artifact(store, *read_receipt(folder, "videos/old.mp4")));
}

/// Its hash is known, and the receipt is where it says: only where it leads to is elsewhere.
TEST_F(StaleTest, StaysWhereAReceiptLeadsElsewhere) {
  Store store(folder);
  put_frames(store, "frames/old");
  write_file(temporary.path() / "thesis.tex", "mine");
  Receipt receipt = *read_receipt(folder, "frames/old");
  for (const std::string& name :
       {std::string("../../../thesis.tex"), (temporary.path() / "thesis.tex").string()}) {
    receipt.frames[0] = {name, hash_of_file(temporary.path() / "thesis.tex"), 4};
    write_file(receipt_path(folder, "frames/old"), to_json(receipt));
    EXPECT_FALSE(read_receipt(folder, "frames/old"));
    EXPECT_TRUE(stale_artifacts(folder, graph_of({}), {}).empty());
    EXPECT_FALSE(remove_artifact(store, receipt));
  }
  for (const char* path : {"../thesis.tex", "/thesis.tex", "a/../../thesis.tex", "", "."}) {
    const Receipt elsewhere{"key", path, hash_of("mine"), 4, {}};
    EXPECT_FALSE(receipt_from_json(to_json(elsewhere))) << path;
    EXPECT_FALSE(remove_artifact(store, elsewhere)) << path;
  }
  EXPECT_EQ(read_file(temporary.path() / "thesis.tex"), "mine");
}

}  // namespace
}  // namespace mien::pipeline
