#include "motion/formats/stated_unit.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/fbx/fbx_scene_builder.h"
#include "pipeline/temporary_folder.h"

using mien::motion::stated_unit;
using mien::test::fbx_arm;
using mien::test::FbxSceneBuilder;
using mien::test::TemporaryFolder;

namespace {

std::filesystem::path written(const TemporaryFolder& folder, const char* name,
                              const std::string& text) {
  std::ofstream(folder.path() / name, std::ios::binary) << text;
  return folder.path() / name;
}

}  // namespace

TEST(StatedUnit, OfFbxIsItsUnitScaleFactorInCentimetres) {
  const TemporaryFolder folder;
  for (const double factor : {1.0, 2.54, 100.0}) {
    FbxSceneBuilder arm = fbx_arm();
    arm.settings.children = {arm.property("UnitScaleFactor", {factor})};
    EXPECT_EQ(stated_unit(written(folder, "arm.FBX", arm.binary())), factor / 100.0);
    EXPECT_EQ(stated_unit(written(folder, "text.fbx", arm.text())), factor / 100.0);
  }
  EXPECT_EQ(stated_unit(written(folder, "arm.fbx", fbx_arm().binary())), std::nullopt);
}

TEST(StatedUnit, OfAcclaimIsThatOfTheSkeletonUnlessItIsOne) {
  const TemporaryFolder folder;
  const auto unit_of = [&](const std::string& length) {
    written(folder, "a.asf",
            ":units\n length " + length +
                "\n angle deg\n:root\n order RX RY RZ\n position 0 0 0\n orientation 0 0 0\n"
                ":bonedata\n:hierarchy\n begin\n end\n");
    return stated_unit(written(folder, "a.amc", ":DEGREES\n1\nroot 0 0 0\n"));
  };
  EXPECT_NEAR(unit_of("0.45").value(), 0.0254 / 0.45, 1e-12);
  EXPECT_EQ(unit_of("1.0"), std::nullopt);
}

TEST(StatedUnit, OfOtherFormatsIsNone) {
  EXPECT_EQ(stated_unit("walk.bvh"), std::nullopt);
  EXPECT_EQ(stated_unit("walk.glb"), std::nullopt);
}
