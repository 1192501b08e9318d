// When checkpoints are taken, that both sides finish them together, and where a run goes on.
//
// Keys: [checkpoint] windows, interval (wall time), at_end, keep (docs/restart.md). A signal always
// asks for one. All calls that say so are made by every rank of both sides at the same point.
#pragma once

#include <functional>
#include <optional>

#include "manifest.hpp"
#include "session_impl.hpp"
#include "windows.hpp"
#include "wishes.hpp"

namespace slidewave {

class Checkpoints {
 public:
  /// Collective. Throws InputError where keys ask for checkpoints that an engine cannot give.
  Checkpoints(Session::Impl& session, Engine const& engine, Windows const& windows);

  /// Collective: the newest complete checkpoint, to go on from; nothing in a fresh directory. One
  /// that is torn is named, and the one before it taken; where none is left the run is refused.
  bool find();
  /// After find(): the window after which the run goes on, -1 in a fresh run.
  long window() const { return found_ ? found_->window : -1; }
  int fluid_ranks() const { return found_ ? found_->fluid_ranks : 0; }
  Spent spent() const { return found_ ? found_->spent : Spent(); }

  /// One function for both ways: everything of this rank that lives across windows.
  using Pass = std::function<void(State&)>;
  void load(Pass const& pass);

  /// What this rank asks for at the end of window `n`.
  Wishes wishes(long n) const;
  /// What is to be done, from what any rank asked for.
  Wishes settle(Wishes asked, long n) const;
  /// Collective, after row `n` of history.csv (`history_bytes` long on the rank that writes it).
  void save(Window const& window, Pass const& pass, long history_bytes, Spent const& spent);

 private:
  bool writer() const;
  bool whole(long window);
  void announce() const;
  void remove_older(long newest) const;
  std::vector<State::Written> gather(State::Written const& mine) const;

  Session::Impl& session_;
  Windows const& windows_;
  std::filesystem::path directory_;
  bool able_;
  long every_ = 0;
  double interval_s_ = 0;
  bool at_end_ = false;
  long keep_ = 2;
  double last_s_;
  std::optional<Manifest> found_;
};

}  // namespace slidewave
