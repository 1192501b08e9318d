#include "slidewave/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "piece.hpp"

namespace slidewave {

struct State::Impl {
  std::unique_ptr<PieceWriter> out;
  std::vector<PieceReader> in;
  bool regrouped = false;

  template <class T>
  void pass(std::string const& name, T* values, long count) {
    long const bytes = count * static_cast<long>(sizeof(T));
    if (out) {
      out->put(name, values, bytes);
      return;
    }
    if (in.front().bytes_of(name) != bytes) {
      throw std::runtime_error(fmt::format("'{}' of the checkpoint has {} bytes, not {}", name,
                                           in.front().bytes_of(name), bytes));
    }
    in.front().get(name, values);
  }
};

State::State(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
State::State(State&&) noexcept = default;
State::~State() = default;

State State::save(std::filesystem::path const& file) {
  auto impl = std::make_unique<Impl>();
  impl->out = std::make_unique<PieceWriter>(file);
  return State(std::move(impl));
}

State State::load(std::filesystem::path const& own) {
  auto impl = std::make_unique<Impl>();
  impl->in.emplace_back(own);
  return State(std::move(impl));
}

State State::load(std::vector<std::filesystem::path> const& pieces) {
  auto impl = std::make_unique<Impl>();
  for (std::filesystem::path const& piece : pieces) {
    impl->in.emplace_back(piece);
  }
  impl->regrouped = true;
  return State(std::move(impl));
}

bool State::saving() const {
  return impl_->out != nullptr;
}
bool State::regrouped() const {
  return impl_->regrouped;
}
int State::pieces() const {
  return static_cast<int>(impl_->in.size());
}

void State::pass(std::string const& name, double* values, long count) {
  impl_->pass(name, values, count);
}
void State::pass(std::string const& name, double& value) {
  impl_->pass(name, &value, 1);
}
void State::pass(std::string const& name, Vec3& value) {
  impl_->pass(name, value.data(), 3);
}
void State::pass(std::string const& name, long& value) {
  impl_->pass(name, &value, 1);
}

void State::pass(std::string const& name, int& value) {
  long wide = value;
  pass(name, wide);
  value = static_cast<int>(wide);
}

void State::pass(std::string const& name, bool& value) {
  long wide = value ? 1 : 0;
  pass(name, wide);
  value = wide != 0;
}

void State::pass(std::string const& name, std::string& value) {
  if (!saving()) {
    value.resize(static_cast<std::size_t>(impl_->in.front().bytes_of(name)));
  }
  impl_->pass(name, value.data(), static_cast<long>(value.size()));
}

void State::pass(std::string const& name, std::vector<double>& values) {
  if (!saving()) {
    values.resize(static_cast<std::size_t>(impl_->in.front().bytes_of(name)) / sizeof(double));
  }
  impl_->pass(name, values.data(), static_cast<long>(values.size()));
}

void State::pass(std::string const& name, std::vector<std::string>& values) {
  std::string lines;
  for (std::string const& value : values) {
    lines += value + "\n";
  }
  pass(name, lines);
  if (saving()) {
    return;
  }
  values.clear();
  for (std::size_t begin = 0; begin < lines.size();) {
    std::size_t const end = lines.find('\n', begin);
    values.push_back(lines.substr(begin, end - begin));
    begin = end + 1;
  }
}

void State::pass_part(std::string const& name, double* values, long begin, long count) {
  if (!regrouped()) {
    pass(name, values, count);
    return;
  }
  std::vector<double> all;
  for (int piece = 0; piece < pieces(); ++piece) {
    std::vector<double> const part = numbers(name, piece);
    all.insert(all.end(), part.begin(), part.end());
  }
  if (begin + count > static_cast<long>(all.size())) {
    throw std::runtime_error(fmt::format("'{}' of the checkpoint has {} numbers, not {}", name,
                                         all.size(), begin + count));
  }
  std::copy_n(all.begin() + begin, count, values);
}

void State::pass_share(std::string const& name, double* values, long count, int rank) {
  if (!regrouped()) {
    pass(name, values, count);
    return;
  }
  std::fill_n(values, count, 0.0);
  for (int piece = 0; rank == 0 && piece < pieces(); ++piece) {
    std::vector<double> const part = numbers(name, piece);
    for (long k = 0; k < count && k < static_cast<long>(part.size()); ++k) {
      values[k] += part[static_cast<std::size_t>(k)];
    }
  }
}

bool State::has(std::string const& name, int piece) const {
  return !saving() && impl_->in.at(static_cast<std::size_t>(piece)).has(name);
}

std::vector<double> State::numbers(std::string const& name, int piece) const {
  PieceReader const& in = impl_->in.at(static_cast<std::size_t>(piece));
  std::vector<double> values(static_cast<std::size_t>(in.bytes_of(name)) / sizeof(double));
  in.get(name, values.data());
  return values;
}

State::Written State::finish() {
  impl_->out->finish();
  return {impl_->out->bytes(), impl_->out->checksum()};
}

}  // namespace slidewave
