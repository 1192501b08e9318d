// The particle side of the exchange: sends each particle to the fluid rank that owns it, and brings
// the answers back to the same rows.
#pragma once

#include <optional>

#include "channel.hpp"
#include "handshake.hpp"
#include "routes.hpp"
#include "sparse.hpp"
#include "windows.hpp"
#include "wishes.hpp"

namespace slidewave {

/// What became of this rank's particles in a window.
struct Census {
  long nearest_cell = 0;  ///< centre outside the mesh by less than a radius: nearest cell used
  long outside = 0;       ///< farther: no fluid acts on them
  double volume_m3 = 0;   ///< of those that the fluid sees
};

class Outbox {
 public:
  Outbox(Session::Impl& session, Agreed const& agreed);
  /// Sends this rank's particles and settles who owns each. Gives what any rank of either side
  /// wishes.
  Wishes send(Table const& particles, long window, Wishes mine);
  /// Fills drag, fluid_velocity, force and memory; zero for particles outside. The tables may share
  /// their memory columns; impulse is still what it was when they were sent.
  void receive(Table const& particles, Table& answers, long window);
  Census const& census() const { return census_; }
  /// Given and not yet received [kg m/s], of all this rank's particles together.
  Vec3 ledger(Table const& particles) const;
  void pass(State& state) { state.pass("outbox.most_outside", most_outside_); }
  /// The fluid's ranks are others than those that memory names: look for all homes once again.
  void forget_homes() { homes_known_ = false; }

 private:
  struct Miss {
    int row;
    int index;  ///< in the message to the rank that was tried
    int tried;
    int winner;
    double distance_m;
  };
  struct Expected {
    int rank;
    std::vector<int> rows;
  };

  void choose_destinations(Table const& particles);
  void pack_field(Table const& particles, Field const& field, int destination, int const* rows,
                  long count, double* out) const;
  void pack_rows(Table const& particles, int const* rows, long count, int destination,
                 double* out) const;
  void read_misses(Table const& particles, long window);
  void query_others(Table const& particles, long window);
  void send_moves(Table const& particles, long window);
  void expect_answers();
  bool all_answered() const;
  void judge_outside(Table const& particles, long window);

  Session::Impl& session_;
  Agreed const& agreed_;
  CoarseMap map_;
  Channel channel_;
  SparseSender sender_;
  Table derived_;  ///< stiff regime only: see contact_memory.hpp
  Groups groups_;
  std::vector<int> owner_;
  std::vector<std::vector<double>> buffers_;
  std::vector<Field> answered_;
  std::optional<Windows> windows_;  ///< stiff regime only, with gravity
  Vec3 gravity_m_s2_ = Vec3::Zero();
  std::vector<double> incoming_;
  std::vector<Miss> misses_;
  std::vector<Expected> expected_;
  std::size_t expected_count_ = 0;
  Census census_;
  long most_outside_ = 0;
  bool homes_known_ = true;  ///< `memory` names ranks and cells of this run
};

}  // namespace slidewave
