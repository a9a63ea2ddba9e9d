#include "pipeline/base/drawing/plot_file.h"

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

Plot small_page() {
  return {"Page", 72.0, 36.0, [](Canvas& canvas) { canvas.text({10.0, 20.0}, "a", {}); }};
}

TEST(PlotFile, HasTheFormatOfItsExtension) {
  EXPECT_TRUE(plot_for_file(small_page(), "out/a.pdf").starts_with("%PDF"));
  EXPECT_TRUE(plot_for_file(small_page(), "a.png").starts_with("\x89PNG"));
  EXPECT_NE(plot_for_file(small_page(), "a.b.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(plot_for_file(small_page(), "a.png"), plot_for_file(small_page(), "b.png"));
}

TEST(PlotFile, IsRefusedWithAnotherName) {
  for (const char* name : {"a.jpg", "a", "png", "a.PNG", "a.png/b"}) {
    try {
      require_plot_file(name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(".png, .svg or .pdf"), std::string::npos);
    }
    EXPECT_THROW(plot_for_file(small_page(), name), Error);
  }
}

}  // namespace
}  // namespace mien::pipeline
