#include "pipeline/manifest/checks/document_checks.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

TEST(KindOfDocument, IsWhatTheKeysSay) {
  using Kind = DocumentKind;
  const std::string manifest = "mien: 1\nstudy: s\nstimuli: []\n";
  for (const char* name : {"stimulus-set.yaml", "a.set.yaml", "my.scales.yaml", "a.recipes.yaml"})
    EXPECT_EQ(kind_of_document(manifest, name), Kind::manifest) << name;
  EXPECT_EQ(kind_of_document("mien: 1\nrecipes: mine.yaml\n", "m.yaml"), Kind::manifest);
  EXPECT_EQ(kind_of_document("recipes: {sad: {paths: 0.5}}\n", "m.yaml"), Kind::recipes);
  EXPECT_EQ(kind_of_document("name: mine\nscales: {a: {low: b, high: c}}\n", "m.yaml"),
            Kind::scales);
  EXPECT_EQ(kind_of_document("background: '#808080'\nlights: []\n", "m.yaml"), Kind::set);
}

TEST(OtherDocuments, AreToldFromManifestsByWhatTheyHold) {
  EXPECT_EQ(to_string(not_a_manifest_fault(DocumentKind::scales, "in/mine.yaml")),
            "in/mine.yaml:1:1: holds scales, and is not a manifest; refer to it in a manifest as "
            "examples: {scales: mine.yaml}; only mien check accepts it directly");
  EXPECT_NE(to_string(not_a_manifest_fault(DocumentKind::set, "a.yaml")).find("{scene: a.yaml}"),
            std::string::npos);
  EXPECT_NE(
      to_string(not_a_manifest_fault(DocumentKind::recipes, "a.yaml")).find("as recipes: a.yaml;"),
      std::string::npos);
}

TEST(KindOfDocument, GoesByTheNameWhereTheKeysSayNothing) {
  using Kind = DocumentKind;
  for (const char* text : {"", "[1, 2]", "a: [1, 2", "zeal: {low: idle}\n"}) {
    EXPECT_EQ(kind_of_document(text, "my.scales.yaml"), Kind::scales) << text;
    EXPECT_EQ(kind_of_document(text, "my.set.yaml"), Kind::set) << text;
    EXPECT_EQ(kind_of_document(text, "my.recipes.yaml"), Kind::recipes) << text;
    EXPECT_EQ(kind_of_document(text, "stimulus-set.yaml"), Kind::manifest) << text;
  }
}

TEST(KindOfDocument, IsRightForEveryFileThatComesWithTheProgram) {
  int files = 0;
  for (const char* folder : {"manifests", "scenes/sets"}) {
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(MIEN_SOURCE_DIR) / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".yaml")) continue;
      const DocumentKind by_name = kind_of_document("", name);
      EXPECT_EQ(kind_of_document(read_file(entry.path()), "nameless.yaml"), by_name) << name;
      if (by_name != DocumentKind::manifest) {
        EXPECT_TRUE(check_other_document(by_name, entry.path()).empty()) << name;
      }
      ++files;
    }
  }
  EXPECT_GT(files, 15);
}

}  // namespace
}  // namespace mien::pipeline
