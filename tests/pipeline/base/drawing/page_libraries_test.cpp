#include "pipeline/base/drawing/page_libraries.h"

#include <gtest/gtest.h>

#include "pipeline/base/drawing/canvas_surface.h"

namespace mien::pipeline {
namespace {

TEST(PageLibraries, TellTheVersionsThatTheLibrariesTellThemselves) {
  EXPECT_EQ(cairo_library(), page_libraries().cairo_version());
  EXPECT_EQ(pango_library(), page_libraries().pango_version());
}

TEST(PageLibraries, ReadVersionsFromTheNamesOfFiles) {
  EXPECT_EQ(cairo_release("2.11600.0"), "1.16.0");
  EXPECT_EQ(cairo_release("2.11804.0"), "1.18.4");
  EXPECT_EQ(cairo_release("2.11804.4"), "1.18.4");
  EXPECT_EQ(pango_release("0.5000.12"), "1.50.12");
  EXPECT_EQ(pango_release("0.5600.3"), "1.56.3");
  for (const char* other :
       {"", "2", "2.11600", "2.11600.0.1", "3.11600.0", "2.7.0", "2.11804.3", "a.b.c"})
    EXPECT_EQ(cairo_release(other), "") << other;
  for (const char* other : {"", "0.5000", "1.5000.12", "0.5000.x", "0.12.5"})
    EXPECT_EQ(pango_release(other), "") << other;
}

}  // namespace
}  // namespace mien::pipeline
