// The fluid side of the exchange: receives particles, locates them, and answers each in its place.
#pragma once

#include "channel.hpp"
#include "handshake.hpp"
#include "sparse.hpp"
#include "wishes.hpp"

namespace slidewave {

class Inbox {
 public:
  Inbox(Session::Impl& session, Agreed const& agreed);
  /// Fills the table (columns of the layout to the fluid) and the cells of this rank's particles:
  /// sorted by cell, for an engine works cell by cell, and within one in an order that does not
  /// depend on when messages arrived. Gives what any rank wishes.
  Wishes collect(FluidEngine& engine, Table& particles, std::vector<int>& cell, long window,
                 Wishes mine);
  /// Sends the columns of the layout to the particle side back to where the rows came from.
  void answer(Table const& answers, std::vector<int> const& cell, long window);

 private:
  /// A message of the first round with what location found.
  struct Batch {
    Incoming* message;
    long rows;
    std::vector<int> cell;
    std::vector<char> stays;
    std::vector<double> misses;
  };
  /// Rows of a message that stay here; where each comes to stand says place_ from `begin` on.
  struct Part {
    Incoming const* message;
    long offset;                     ///< of its first block [doubles]
    long rows;                       ///< that it holds
    std::vector<char> const* stays;  ///< which of them; null: all
    long begin;
  };
  /// Rows that came from, and go back to, one dem rank: place_ from `begin` on.
  struct Span {
    int source;
    long begin;
    long rows;
    std::vector<double>* buffer;  ///< the message they came in, done with: the answer's now
  };

  void locate(FluidEngine& engine, long window);
  void answer_queries(FluidEngine& engine, long window);
  void read_moves(long window);
  void list_parts(FluidEngine& engine, std::vector<int>& cell);
  void sort_by_cell(std::vector<int>& cell);
  void pack_answers(Table const& answers, std::vector<int> const& cell, int const* rows, long count,
                    double* out) const;
  void copy_rows(Part const& part, Table& particles) const;

  Session::Impl& session_;
  Agreed const& agreed_;
  Channel channel_;
  SparseReceiver particles_;
  SparseReceiver queries_;
  SparseReceiver moves_;
  std::vector<Batch> batches_;
  std::size_t batch_count_ = 0;
  std::vector<Incoming*> moved_;
  std::vector<Part> parts_;
  std::vector<Span> spans_;
  std::vector<int> place_;  ///< row of the table, of each that stays, in the order of parts_
  std::vector<int> next_;   ///< row of the next particle in each cell
};

}  // namespace slidewave
