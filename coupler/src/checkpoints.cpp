#include "checkpoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "durable.hpp"
#include "piece.hpp"
#include "signals.hpp"

namespace slidewave {
namespace {

namespace fs = std::filesystem;

std::string case_file(Session::Impl const& session) {
  return (session.scene.directory() / "case.toml").string();
}

double at_least(Session::Impl const& session, std::string const& key, double least,
                double otherwise) {
  double const value = session.scene.number(key, otherwise);
  if (!(value >= least)) {
    throw InputError(case_file(session), key, fmt::format("{}", value),
                     fmt::format("must be at least {}", least));
  }
  return value;
}

}  // namespace

Checkpoints::Checkpoints(Session::Impl& session, Engine const& engine, Windows const& windows)
    : session_(session),
      windows_(windows),
      directory_(fs::absolute(session.scene.directory())),
      able_(false),
      last_s_(now_s()) {
  Scene const& scene = session.scene;
  if (scene.has("checkpoint.windows")) {
    every_ = static_cast<long>(at_least(session, "checkpoint.windows", 1, 1));
  }
  if (scene.has("checkpoint.interval")) {
    interval_s_ = at_least(session, "checkpoint.interval", 0, 0);
  }
  at_end_ = scene.flag("checkpoint.at_end", false);
  keep_ = static_cast<long>(at_least(session, "checkpoint.keep", 1, 2));

  double unable = engine.passes_state() ? 0 : 1;
  session.agreement.sum_all(&unable, 1, "the engines to tell whether they can restart");
  able_ = unable == 0;
  bool const wanted = every_ > 0 || interval_s_ > 0 || at_end_;
  if (!able_ && wanted && !engine.passes_state()) {
    throw InputError(case_file(session), "checkpoint", "",
                     fmt::format("the {} engine cannot save its state: leave [checkpoint] out",
                                 name_of(session.role)));
  }
}

bool Checkpoints::writer() const {
  return session_.is_root() && (session_.role == Role::fluid || !session_.world.has_partner());
}

// Whether this rank's pieces are what the manifest says; on the writer, all names and sizes too.
bool Checkpoints::whole(long window) {
  std::string fault;
  try {
    found_ = Manifest::read(directory_, window);
    fault = writer() ? found_->fault(directory_) : "";
    bool const fluid = session_.role == Role::fluid;
    int const saved = fluid ? found_->fluid_ranks : found_->dem_ranks;
    for (int r = session_.world.rank; fault.empty() && r < saved; r += session_.world.size) {
      fs::path const file = Manifest::folder(directory_, window) / Manifest::piece_name(fluid, r);
      if (PieceReader::checksum(file) != found_->piece(fluid, r).checksum) {
        fault = file.filename().string() + " is not what was written (checksum)";
      }
    }
  } catch (std::runtime_error const& error) {
    fault = writer() ? error.what() : "";  // all ranks meet it: let one speak
  }
  if (!fault.empty()) {
    session_.failure.terminal().say(
        fmt::format("slidewave: the checkpoint of window {} is not used: {}", window, fault));
  }
  double faults = fault.empty() ? 0 : 1;
  session_.agreement.sum_all(&faults, 1, "all ranks to check the checkpoint");
  return faults == 0;
}

bool Checkpoints::find() {
  std::vector<long> const candidates =
      writer() ? Manifest::windows(directory_) : std::vector<long>();
  bool any = false;
  for (std::size_t next = 0;; ++next) {
    double proposed =
        next < candidates.size() ? static_cast<double>(candidates[next] + 1) : 0;  // 0: no more
    session_.agreement.sum_all(&proposed, 1, "the choice of a checkpoint");
    if (proposed == 0) {
      break;
    }
    any = true;
    if (whole(std::lround(proposed) - 1)) {
      announce();
      return true;
    }
    found_.reset();
  }
  if (any) {
    throw InputError(Manifest::folder(directory_).string(), "checkpoints", "",
                     "none of them is complete; remove the folder to start from the beginning");
  }
  return false;
}

void Checkpoints::announce() const {
  if (!able_) {
    throw InputError(Manifest::folder(directory_).string(), "checkpoints", "",
                     "an engine of this case cannot go on from them; remove the folder to start "
                     "from the beginning");
  }
  double const window_s = session_.scene.number("coupling.window");
  if (std::abs(window_s - found_->window_s) > 1e-12 * window_s) {
    throw InputError(
        case_file(session_), "coupling.window", fmt::format("{}", window_s),
        fmt::format("the checkpoint has windows of {} s: a restart keeps them", found_->window_s));
  }
  if (!writer()) {
    return;
  }
  auto const& world = session_.world;
  bool const is_fluid = session_.role == Role::fluid;
  int const fluid = is_fluid ? world.size : world.partner_size;
  int const dem = is_fluid ? world.partner_size : world.size;
  std::string text =
      fmt::format("going on after window {}, t = {:.6g} s ({})", found_->window, found_->time_s,
                  Manifest::folder(directory_, found_->window).string());
  if (fluid != found_->fluid_ranks || dem != found_->dem_ranks) {
    text += fmt::format("; on {} + {} ranks instead of {} + {}: not bit for bit", fluid, dem,
                        found_->fluid_ranks, found_->dem_ranks);
  } else if (session_.scene.fingerprint() != found_->fingerprint) {
    text += "; case.toml has changed since: not the same run";
  }
  if (version() != found_->version) {
    text += fmt::format("; written by slidewave {}, this is {}", found_->version, version());
  }
  session_.say("slidewave: " + text);
}

void Checkpoints::load(Pass const& pass) {
  bool const fluid = session_.role == Role::fluid;
  int const saved = fluid ? found_->fluid_ranks : found_->dem_ranks;
  fs::path const folder = Manifest::folder(directory_, found_->window);
  if (saved == session_.world.size) {
    State state = State::load(folder / Manifest::piece_name(fluid, session_.world.rank));
    pass(state);
    return;
  }
  std::vector<fs::path> pieces;
  pieces.reserve(static_cast<std::size_t>(saved));
  for (int r = 0; r < saved; ++r) {
    pieces.push_back(folder / Manifest::piece_name(fluid, r));
  }
  State state = State::load(pieces);
  pass(state);
}

Wishes Checkpoints::wishes(long n) const {
  Wishes mine;
  mine.stop = stop_was_asked();
  mine.checkpoint = (every_ > 0 && n % every_ == 0) || (at_end_ && n == windows_.count()) ||
                    (interval_s_ > 0 && writer() && now_s() - last_s_ > interval_s_);
  return mine;
}

Wishes Checkpoints::settle(Wishes asked, long n) const {
  asked.stop = asked.stop && n < windows_.count();
  asked.checkpoint = able_ && n > 0 && (asked.checkpoint || asked.stop);
  return asked;
}

void Checkpoints::save(Window const& window, Pass const& pass, long history_bytes,
                       Spent const& spent) {
  bool const fluid = session_.role == Role::fluid;
  fs::path const folder = Manifest::folder(directory_, window.index);
  double nothing = 0;
  if (writer()) {
    fs::remove_all(folder);  // torn ones of an earlier run
    fs::create_directories(folder);
  }
  session_.agreement.sum_all(&nothing, 1, "both sides to begin the checkpoint");
  State state = State::save(folder / Manifest::piece_name(fluid, session_.world.rank));
  pass(state);
  auto const pieces = gather(state.finish());
  if (writer()) {
    sync_directory(folder);
    Manifest manifest;
    manifest.window = window.index;
    manifest.time_s = window.t1_s;
    manifest.window_s = session_.scene.number("coupling.window");
    manifest.version = version();
    manifest.fingerprint = session_.scene.fingerprint();
    manifest.fluid_ranks = fluid ? session_.world.size : 0;
    manifest.dem_ranks = fluid ? session_.world.partner_size : session_.world.size;
    manifest.history_bytes = history_bytes;
    manifest.spent = spent;
    manifest.pieces = pieces;
    manifest.write(directory_);
    sync_directory(Manifest::folder(directory_));
    remove_older(window.index);
  }
  session_.agreement.sum_all(&nothing, 1, "both sides to finish the checkpoint");
  last_s_ = now_s();
}

// The pieces of all ranks on the writer, fluid first.
std::vector<State::Written> Checkpoints::gather(State::Written const& mine) const {
  double const half = 4294967296.0;
  std::vector<double> numbers = session_.agreement.gather_on_side(
      {static_cast<double>(mine.bytes), static_cast<double>(mine.checksum >> 32),
       static_cast<double>(mine.checksum & 0xffffffffU)},
      "this side's checkpoint");
  if (session_.is_root() && session_.world.has_partner()) {
    if (session_.role == Role::dem) {
      session_.agreement.send_text(nlohmann::json(numbers).dump(), "the checkpoint's files");
    } else {
      std::vector<double> const theirs =
          nlohmann::json::parse(session_.agreement.receive_text("the files of its checkpoint"));
      numbers.insert(numbers.end(), theirs.begin(), theirs.end());
    }
  }
  std::vector<State::Written> pieces;
  for (std::size_t k = 0; k < numbers.size(); k += 3) {
    pieces.push_back({std::lround(numbers[k]), static_cast<std::uint64_t>(numbers[k + 1]) *
                                                       static_cast<std::uint64_t>(half) +
                                                   static_cast<std::uint64_t>(numbers[k + 2])});
  }
  return pieces;
}

// Keeps the newest ones. Later ones than `newest` were torn, or this run would have begun there.
void Checkpoints::remove_older(long newest) const {
  long kept = 0;
  for (long const window : Manifest::windows(directory_)) {
    if (window > newest || ++kept > keep_) {
      fs::remove(
          Manifest::file(directory_, window));  // first: without it the rest is no checkpoint
      fs::remove_all(Manifest::folder(directory_, window));
    }
  }
  for (auto const& entry : fs::directory_iterator(Manifest::folder(directory_))) {
    if (!fs::exists(entry.path() / "manifest.json")) {
      fs::remove_all(entry.path());  // a crash in the middle of writing left it
    }
  }
}

}  // namespace slidewave
