// What a set-up script must not say is found, includes and continued lines too.
#include <gtest/gtest.h>

#include <fstream>

#include "script_scan.h"

namespace {

namespace fs = std::filesystem;

fs::path written(std::string const& name, std::string const& content) {
  fs::create_directories("scripts");
  fs::path const file = fs::path("scripts") / name;
  std::ofstream(file) << content;
  return file;
}

TEST(ScriptScan, FindsDumpsThatUseVtk) {
  for (std::string const style : {"custom/vtk", "mesh/vtk", "custom/vtm", "atom/vtk"}) {
    fs::path const script = written("a", "units si\n\ndump d all " + style + " 10 x.vtk id\n");
    auto const found = slidewave::dem::find_forbidden(script, "scripts");
    EXPECT_EQ(found.command, "dump " + style);
    EXPECT_EQ(found.line, 3);
  }
}

TEST(ScriptScan, FollowsIncludesAndContinuedLines) {
  written("inner", "# first\ndump d &\n all &\n mesh/vtk 5 m.vtk\n");
  auto const found = slidewave::dem::find_forbidden(written("outer", "include inner\n"), "scripts");
  EXPECT_EQ(found.command, "dump mesh/vtk");
  EXPECT_EQ(found.line, 2);
  EXPECT_EQ(found.file.filename(), "inner");
}

TEST(ScriptScan, FindsClear) {
  EXPECT_EQ(slidewave::dem::find_forbidden(written("c", "clear # all\n"), "scripts").command,
            "clear");
}

TEST(ScriptScan, LetsTheRestPass) {
  fs::path const script = written(
      "b",
      "dump d all custom 10 x.txt id x\ndump m all mesh/stl 5 m*.stl\n# dump d all mesh/vtk\n"
      "variable vtk index clear\ninclude missing\ninclude b\n");
  EXPECT_TRUE(slidewave::dem::find_forbidden(script, "scripts").command.empty());
}

}  // namespace
