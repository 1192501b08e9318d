// A checkpoint's pieces: what goes in comes out, to the last bit, and damage is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "budgets.hpp"
#include "history.hpp"
#include "manifest.hpp"
#include "piece.hpp"
#include "scratch.hpp"

using namespace slidewave;
namespace fs = std::filesystem;

namespace {

std::string text_of(fs::path const& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void damage(fs::path const& file, long offset) {
  std::fstream both(file, std::ios::in | std::ios::out | std::ios::binary);
  both.seekg(offset);
  char const other = static_cast<char>(both.get() ^ 1);
  both.seekp(offset);
  both.put(other);
}

}  // namespace

TEST(State, GivesBackEveryBit) {
  Scratch const scratch("");
  std::vector<double> numbers = {0.1, -0.0, 5e-324, std::nan(""), INFINITY, 1.0 / 3};
  std::vector<std::string> words = {"a", "", "two words"};
  std::string text = "seven b";
  double one = M_PI;
  long whole = (1L << 60) + 1;
  int small = -3;
  bool yes = true;
  Vec3 vector(1e-300, 2, 3);
  double place[4] = {1, 2, 3, 4};
  auto const pass = [&](State& state) {
    state.pass("numbers", numbers);
    state.pass("words", words);
    state.pass("text", text);
    state.pass("one", one);
    state.pass("whole", whole);
    state.pass("small", small);
    state.pass("yes", yes);
    state.pass("vector", vector);
    state.pass("place", place, 4);
  };
  State out = State::save(scratch.path / "piece");
  pass(out);
  State::Written const written = out.finish();
  EXPECT_EQ(written.bytes, static_cast<long>(fs::file_size(scratch.path / "piece")));
  EXPECT_EQ(written.checksum, PieceReader::checksum(scratch.path / "piece"));

  auto const before = numbers;
  numbers.clear();
  words = {"x"};
  text = "";
  one = whole = small = 0;
  yes = false;
  vector.setZero();
  place[3] = 0;
  State in = State::load(scratch.path / "piece");
  pass(in);
  ASSERT_EQ(numbers.size(), before.size());
  EXPECT_EQ(std::memcmp(numbers.data(), before.data(), sizeof(double) * before.size()), 0);
  EXPECT_EQ(words, (std::vector<std::string>{"a", "", "two words"}));
  EXPECT_EQ(text, "seven b");
  EXPECT_EQ(one, M_PI);
  EXPECT_EQ(whole, (1L << 60) + 1);
  EXPECT_EQ(small, -3);
  EXPECT_TRUE(yes);
  EXPECT_EQ(vector, Vec3(1e-300, 2, 3));
  EXPECT_EQ(place[3], 4);
  EXPECT_TRUE(in.has("one"));
  EXPECT_FALSE(in.has("two"));
}

TEST(State, RefusesWhatWasNotSaved) {
  Scratch const scratch("");
  double values[2] = {1, 2};
  State out = State::save(scratch.path / "piece");
  out.pass("x", values, 2);
  EXPECT_THROW(out.pass("x", values, 2), std::logic_error);
  out.finish();
  State in = State::load(scratch.path / "piece");
  EXPECT_THROW(in.pass("y", values, 2), std::runtime_error);
  EXPECT_THROW(in.pass("x", values, 1), std::runtime_error);
  EXPECT_THROW(State::save(scratch.path / "none" / "piece"), std::runtime_error);
  EXPECT_THROW(State::load(scratch.path / "none"), std::runtime_error);
}

TEST(State, DealsALongArrayOutToOtherRanks) {
  Scratch const scratch("");
  std::vector<fs::path> files;
  std::vector<double> all(11);
  for (int k = 0; k < 11; ++k) {
    all[static_cast<std::size_t>(k)] = 1.5 * k;
  }
  for (int rank = 0; rank < 3; ++rank) {  // of 4, 4 and 3
    files.push_back(scratch.path / std::to_string(rank));
    State out = State::save(files.back());
    out.pass_part("x", all.data() + 4 * rank, 4 * rank, rank < 2 ? 4 : 3);
    out.finish();
  }
  std::vector<double> found(11, -1);
  for (int rank = 0; rank < 2; ++rank) {  // of 6 and 5
    State in = State::load(files);
    EXPECT_TRUE(in.regrouped());
    in.pass_part("x", found.data() + 6 * rank, 6 * rank, 6 - rank);
  }
  EXPECT_EQ(found, all);
  State in = State::load(files);
  EXPECT_THROW(in.pass_part("x", found.data(), 8, 4), std::runtime_error);
}

// Wherever a byte changes or a file ends, size or checksum tell.
TEST(State, SeesDamage) {
  Scratch const scratch("");
  fs::path const file = scratch.path / "piece";
  std::vector<double> numbers(50, 0.25);
  State out = State::save(file);
  out.pass("numbers", numbers);
  State::Written const written = out.finish();
  for (long offset = 0; offset < written.bytes; offset += 7) {
    damage(file, offset);
    EXPECT_NE(PieceReader::checksum(file), written.checksum) << offset;
    damage(file, offset);
  }
  EXPECT_EQ(PieceReader::checksum(file), written.checksum);
  std::mt19937 random(7);
  for (int k = 0; k < 20; ++k) {  // a torn piece is refused or, at a seam, misses its block
    fs::copy_file(file, scratch.path / "torn", fs::copy_options::overwrite_existing);
    fs::resize_file(scratch.path / "torn", random() % static_cast<unsigned>(written.bytes));
    EXPECT_THROW(State::load(scratch.path / "torn").pass("numbers", numbers), std::runtime_error);
  }
}

TEST(Manifest, ComesBackAndKnowsItsFiles) {
  Scratch const scratch("");
  EXPECT_TRUE(Manifest::windows(scratch.path).empty());
  Manifest manifest;
  manifest.window = 12;
  manifest.time_s = 0.1;
  manifest.window_s = 1.0 / 120;
  manifest.version = "1";
  manifest.fingerprint = "f";
  manifest.fluid_ranks = manifest.dem_ranks = 1;
  manifest.history_bytes = 3;
  manifest.spent.wall_s = 2.5;
  manifest.spent.dem_s[2] = 7;
  manifest.pieces = {{4, 0xfedcba9876543210ULL}, {2, 1}};
  fs::path const folder = Manifest::folder(scratch.path, 12);
  fs::create_directories(folder);
  std::ofstream(folder / "fluid.0") << "1234";
  std::ofstream(folder / "dem.0") << "12";
  std::ofstream(scratch.path / "history.csv") << "123";
  EXPECT_TRUE(Manifest::windows(scratch.path).empty());  // files without a manifest are none
  manifest.write(scratch.path);
  EXPECT_EQ(Manifest::windows(scratch.path), std::vector<long>{12});

  Manifest const read = Manifest::read(scratch.path, 12);
  EXPECT_EQ(read.time_s, 0.1);
  EXPECT_EQ(read.window_s, 1.0 / 120);
  EXPECT_EQ(read.piece(true, 0).checksum, 0xfedcba9876543210ULL);
  EXPECT_EQ(read.piece(false, 0).bytes, 2);
  EXPECT_EQ(read.spent.dem_s[2], 7);
  EXPECT_EQ(read.fault(scratch.path), "");
  std::ofstream(folder / "dem.0") << "123";
  EXPECT_NE(read.fault(scratch.path).find("dem.0 has 3 bytes instead of 2"), std::string::npos);
  fs::remove(folder / "dem.0");
  EXPECT_EQ(read.fault(scratch.path), "dem.0 is missing");
  std::ofstream(folder / "manifest.json") << "{\"window\": 12";
  EXPECT_THROW(Manifest::read(scratch.path, 12), std::runtime_error);
}

TEST(History, IsCutToItsCheckpoint) {
  Scratch const scratch("");
  fs::path const file = scratch.path / "history.csv";
  Window window;
  {
    History history(file);
    history.add(window, {{"a", 1}});
    State out = State::save(scratch.path / "piece");
    history.pass(out);
    out.finish();
    window.index = 1;
    history.add(window, {{"a", 2}});
  }
  History history(file, true);
  State in = State::load(scratch.path / "piece");
  history.pass(in);
  window.index = 7;
  history.add(window, {{"a", 3}});
  EXPECT_THROW(history.add(window, {{"b", 3}}), std::runtime_error);
  EXPECT_EQ(text_of(file), "window,time_s,a\n0,0,1\n7,0,3\n");
}

// Budgets that went through a checkpoint go on as if there had been none.
TEST(Budgets, GoOnFromACheckpoint) {
  Scratch const scratch("");
  Models models;
  Budgets straight(models, Vec3(1, 0, 1));
  Budgets saved = straight;
  Budgets loaded = straight;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int n = 0; n < 30; ++n) {
    DemSums dem;
    FluidSums fluid;
    for (int k = 0; k < count_of<DemSums>(); ++k) {
      numbers_of(dem)[k] = some(random);
    }
    for (int k = 0; k < count_of<FluidSums>(); ++k) {
      numbers_of(fluid)[k] = some(random);
    }
    straight.add(0.1, 9.81, dem, fluid);
    (n < 15 ? saved : loaded).add(0.1, 9.81, dem, fluid);
    if (n == 14) {
      State out = State::save(scratch.path / "piece");
      saved.pass(out);
      out.finish();
      State in = State::load(scratch.path / "piece");
      loaded.pass(in);
    }
  }
  auto const one = straight.columns();
  auto const other = loaded.columns();
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].value, other[k].value) << one[k].name;
  }
}
