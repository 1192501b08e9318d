#include <gtest/gtest.h>

#include "scratch.hpp"
#include "slidewave/scene.hpp"

using namespace slidewave;

namespace {

std::string error_of(std::string const& text, void (*use)(Scene const&)) {
  Scratch const scratch(text);
  try {
    Scene const scene(scratch.path);
    use(scene);
  } catch (InputError const& error) {
    return error.what();
  }
  return "";
}

bool has(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

char const* const text = R"([case]
name = "x"
end_time = 50
[physics]
gravity = [0, 0.0, -9.81]
[variant.quick.coupling]
window = 0.1
[variant.a]
[parameters]
zeta = 1.5
alpha = "s"
on = true
)";

}  // namespace

TEST(Scene, ReadsDottedKeys) {
  Scratch const scratch(text);
  Scene const scene(scratch.path);
  EXPECT_EQ(scene.number("case.end_time"), 50);
  EXPECT_EQ(scene.number("variant.quick.coupling.window"), 0.1);
  EXPECT_EQ(scene.number("coupling.window", 7), 7);
  EXPECT_EQ(scene.text("case.name"), "x");
  EXPECT_EQ(scene.vector("physics.gravity"), Vec3(0, 0, -9.81));
  EXPECT_TRUE(scene.flag("parameters.on", false));
  EXPECT_TRUE(scene.flag("parameters.off", true));
  EXPECT_FALSE(scene.has("case.nothing"));
  EXPECT_EQ(scene.directory(), scratch.path);
}

TEST(Scene, ListsKeysInFileOrder) {
  Scratch const scratch(text);
  Scene const scene(scratch.path);
  EXPECT_EQ(scene.keys("parameters"), (std::vector<std::string>{"zeta", "alpha", "on"}));
  EXPECT_EQ(scene.keys("variant"), (std::vector<std::string>{"quick", "a"}));
  EXPECT_TRUE(scene.keys("observe").empty());
}

TEST(Scene, NamesFileKeyValueAndRemedy) {
  auto const wrong_type =
      error_of(text, [](Scene const& scene) { (void)scene.number("parameters.alpha"); });
  EXPECT_TRUE(has(wrong_type, "case.toml")) << wrong_type;
  EXPECT_TRUE(has(wrong_type, "parameters.alpha")) << wrong_type;
  EXPECT_TRUE(has(wrong_type, "\"s\"") || has(wrong_type, "'s'")) << wrong_type;
  EXPECT_TRUE(has(wrong_type, "a finite number")) << wrong_type;
  // A default is for a missing key only, not for a bad one.
  EXPECT_NE(error_of(text, [](Scene const& s) { (void)s.number("parameters.alpha", 1.0); }), "");
  EXPECT_TRUE(has(error_of(text, [](Scene const& s) { (void)s.number("case.start"); }), "missing"));
  EXPECT_TRUE(has(error_of("a = nan", [](Scene const& s) { (void)s.number("a"); }), "finite"));
  EXPECT_TRUE(has(error_of("a = [1, 2]", [](Scene const& s) { (void)s.vector("a"); }), "three"));
  EXPECT_TRUE(has(error_of("a = 1\nb", [](Scene const&) {}), "line 2"));
}

TEST(Scene, MissingFileIsInputError) {
  EXPECT_THROW(Scene("/nonexistent/directory"), InputError);
}

TEST(Scene, FingerprintIsThatOfTheText) {
  Scratch const scratch("");
  EXPECT_EQ(Scene(scratch.path).fingerprint(), "cbf29ce484222325");  // FNV-1a of nothing
  std::ofstream(scratch.path / "case.toml") << "a";
  EXPECT_THROW(Scene(scratch.path), InputError);
  std::ofstream(scratch.path / "case.toml") << "a=1";
  std::string const one = Scene(scratch.path).fingerprint();
  std::ofstream(scratch.path / "case.toml") << "a=2";
  EXPECT_NE(Scene(scratch.path).fingerprint(), one);
}
