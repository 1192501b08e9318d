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
  /// Fills the table (columns of the layout to the fluid) and the cells of this rank's particles,
  /// in an order that does not depend on when messages arrived. Gives what any rank wishes.
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
  /// Rows of the table that came from, and go back to, one dem rank.
  struct Span {
    int source;
    long begin;
    long rows;
    std::vector<double>* buffer;  ///< the message they came in, done with: the answer's now
  };

  void locate(FluidEngine& engine, long window);
  void answer_queries(FluidEngine& engine, long window);
  void read_moves(long window);
  void build(FluidEngine& engine, Table& particles, std::vector<int>& cell);
  void copy_rows(Incoming const& message, long offset, long rows, std::vector<char> const* stays,
                 Table& particles, long begin) const;

  Session::Impl& session_;
  Agreed const& agreed_;
  Channel channel_;
  SparseReceiver particles_;
  SparseReceiver queries_;
  SparseReceiver moves_;
  std::vector<Batch> batches_;
  std::size_t batch_count_ = 0;
  std::vector<Incoming*> moved_;
  std::vector<Span> spans_;
};

}  // namespace slidewave
