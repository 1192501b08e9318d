// What lives across windows, on its way into a checkpoint or out of one. One function does both:
//
//   void MyEngine::pass(State& state) {
//     state.pass("my.time_s", time_s_);  // saves it, or sets it to what was saved
//     state.pass("my.x_m", x_m_);
//   }
//
// Each rank saves a piece of its own. After a restart on as many ranks each loads its own piece
// again; on other ranks (regrouped()) it sees all of them and takes what is its share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "slidewave/table.hpp"

namespace slidewave {

class State {
 public:
  /// What came to stand on disk: its size, and a checksum of all its bytes (64-bit FNV-1a of
  /// words).
  struct Written {
    long bytes = 0;
    std::uint64_t checksum = 0;
  };

  /// Begins this rank's piece. Throws std::runtime_error where a file cannot be written.
  static State save(std::filesystem::path const& file);
  /// Reads `own`, or all `pieces` where they were saved by another number of ranks.
  static State load(std::filesystem::path const& own);
  static State load(std::vector<std::filesystem::path> const& pieces);
  State(State&&) noexcept;
  ~State();

  bool saving() const;
  /// Loading pieces of other ranks than now run: pass() reads the first piece, what is spread over
  /// the ranks has to be gathered with numbers().
  bool regrouped() const;
  int pieces() const;

  /// Saves or sets a value. Names are unique in a piece; loading one that was not saved throws
  /// std::runtime_error naming it.
  void pass(std::string const& name, double& value);
  void pass(std::string const& name, long& value);
  void pass(std::string const& name, int& value);
  void pass(std::string const& name, bool& value);
  void pass(std::string const& name, Vec3& value);
  void pass(std::string const& name, std::string& value);
  void pass(std::string const& name, std::vector<double>& values);
  void pass(std::string const& name, std::vector<std::string>& values);
  /// `count` numbers in place; as many must have been saved.
  void pass(std::string const& name, double* values, long count);

  /// Part of a long array that the ranks hold in order: saves this rank's `count` numbers; loads
  /// those from `begin` on, counted over all ranks, whichever ranks saved them.
  void pass_part(std::string const& name, double* values, long begin, long count);

  /// Numbers of which all ranks' sum counts: on other ranks than saved them the first one (`rank`
  /// 0) takes the whole, the others nothing.
  void pass_share(std::string const& name, double* values, long count, int rank);

  bool has(std::string const& name, int piece = 0) const;
  /// The numbers of one piece, in any mode of loading.
  std::vector<double> numbers(std::string const& name, int piece) const;

  /// After saving: waits until all of it is on disk.
  Written finish();

 private:
  struct Impl;
  explicit State(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace slidewave
