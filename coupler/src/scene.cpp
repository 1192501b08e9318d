#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 1
#include "slidewave/scene.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace slidewave {

InputError::InputError(std::string const& file, std::string const& key, std::string const& value,
                       std::string const& remedy)
    : std::runtime_error(file + ": " + key + (value.empty() ? "" : " = " + value) + ": " + remedy) {
}

struct Scene::Impl {
  std::filesystem::path directory;
  std::string raw;
  toml::table root;

  std::string file() const { return (directory / "case.toml").string(); }

  toml::node const* find(std::string const& key) const { return root.at_path(key).node(); }

  std::string shown(toml::node const& node) const {
    std::ostringstream text;
    node.visit([&](auto const& value) { text << value; });
    return text.str();
  }

  template <class T>
  T require(std::string const& key, std::optional<T> const& value, char const* type) const {
    if (value) {
      return *value;
    }
    toml::node const* node = find(key);
    throw InputError(
        file(), key, node ? shown(*node) : "",
        node ? fmt::format("must be {}", type) : fmt::format("is missing; add it as {}", type));
  }

  std::optional<double> number(std::string const& key) const {
    toml::node const* node = find(key);
    auto value = node && node->is_number() ? node->value<double>() : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  std::optional<std::string> text(std::string const& key) const {
    toml::node const* node = find(key);
    return node && node->is_string() ? node->value<std::string>() : std::nullopt;
  }
};

namespace {

std::string read_file(std::filesystem::path const& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError(path.string(), "(file)", "",
                     "cannot be read; give the run directory that 'slidewave run --dry-run' wrote");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Scene::Scene(std::filesystem::path const& run_directory) : impl_(std::make_unique<Impl>()) {
  impl_->directory = std::filesystem::absolute(run_directory).lexically_normal();
  impl_->raw = read_file(impl_->directory / "case.toml");
  try {
    impl_->root = toml::parse(impl_->raw);
  } catch (toml::parse_error const& error) {
    throw InputError(impl_->file(), fmt::format("line {}", error.source().begin.line), "",
                     fmt::format("is not valid TOML: {}", error.description()));
  }
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;

std::filesystem::path const& Scene::directory() const {
  return impl_->directory;
}

double Scene::number(std::string const& key) const {
  return impl_->require(key, impl_->number(key), "a finite number");
}

double Scene::number(std::string const& key, double otherwise) const {
  return has(key) ? number(key) : otherwise;
}

std::string Scene::text(std::string const& key) const {
  return impl_->require(key, impl_->text(key), "a text in quotes");
}

std::string Scene::text(std::string const& key, std::string const& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

bool Scene::flag(std::string const& key, bool otherwise) const {
  toml::node const* node = impl_->find(key);
  if (!node) {
    return otherwise;
  }
  return impl_->require(key, node->is_boolean() ? node->value<bool>() : std::nullopt,
                        "true or false");
}

Vec3 Scene::vector(std::string const& key) const {
  toml::node const* node = impl_->find(key);
  std::optional<Vec3> value;
  if (node && node->is_array() && node->as_array()->size() == 3) {
    Vec3 read;
    bool numbers = true;
    for (int k = 0; k < 3; ++k) {
      toml::node const& entry = (*node->as_array())[k];
      numbers = numbers && entry.is_number();
      read[k] = entry.value<double>().value_or(NAN);
    }
    if (numbers && read.allFinite()) {
      value = read;
    }
  }
  return impl_->require(key, value, "three finite numbers, e.g. [0.0, 0.0, -9.81]");
}

std::vector<double> Scene::numbers(std::string const& key) const {
  toml::node const* node = impl_->find(key);
  std::vector<double> read;
  bool good = node && node->is_array();
  if (good) {
    for (toml::node const& entry : *node->as_array()) {
      read.push_back(entry.is_number() ? entry.value<double>().value_or(NAN) : NAN);
      good = good && std::isfinite(read.back());
    }
  }
  return impl_->require(key, good && !read.empty() ? std::optional(read) : std::nullopt,
                        "a list of finite numbers, e.g. [1.0, 2.0]");
}

bool Scene::has(std::string const& key) const {
  return impl_->find(key) != nullptr;
}

std::vector<std::string> Scene::keys(std::string const& table) const {
  toml::node const* node = table.empty() ? &impl_->root : impl_->find(table);
  std::vector<std::pair<toml::source_position, std::string>> found;
  if (node && node->is_table()) {
    for (auto const& [key, value] : *node->as_table()) {
      found.emplace_back(key.source().begin, std::string(key.str()));
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> names;
  names.reserve(found.size());
  for (auto const& [position, name] : found) {
    names.push_back(name);
  }
  return names;
}

std::string Scene::fingerprint() const {
  std::uint64_t hash = 14695981039346656037ULL;
  for (unsigned char byte : impl_->raw) {
    hash = (hash ^ byte) * 1099511628211ULL;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace slidewave
