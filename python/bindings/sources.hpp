#pragma once

#include <memory>
#include <nanobind/nanobind.h>
#include <string>
#include <utility>

#include "python/bindings/errors.hpp"
#include "python/bindings/python_calls.hpp"
#include "python/environments/episodes.hpp"

namespace fulbito::python {

/// A source of episodes on its way from the function that made it to the environment that plays it.
struct Source {
  std::unique_ptr<EpisodeSource> episodes;
  SharedFailure failure = {};  ///< keeps what teams of this process raise

  /// The source, which can be taken once.
  std::unique_ptr<EpisodeSource> take() {
    if (!episodes) throw StateFailure("this source of episodes belongs to another environment");
    return std::move(episodes);
  }
};

/// Reads keyword arguments one by one. Errors are UsageError with the name of the argument.
class Arguments {
 public:
  explicit Arguments(nanobind::dict values) : values_(std::move(values)) {}

  /// The argument as a T, or `fallback` if it is missing or None.
  template <typename T>
  T get(const char* name, T fallback, const char* kind) const {
    if (!values_.contains(name)) return fallback;
    const nanobind::object value = values_[name];
    if (value.is_none()) return fallback;
    T read{};
    if (nanobind::try_cast(value, read)) return read;
    raise(ErrorCode::kUsage, std::string(name) + ": " + nanobind::repr(value).c_str() + " is no " + kind);
  }
  /// The argument as one of `choices`, by its index.
  template <typename Choices>
  std::size_t choice(const char* name, const Choices& choices) const {
    const std::string wanted = get<std::string>(name, choices[0], "text");
    std::string all;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (wanted == choices[i]) return i;
      all += std::string(i > 0 ? ", " : "") + choices[i];
    }
    raise(ErrorCode::kUsage, std::string(name) + ": '" + wanted + "' is none of " + all);
  }

 private:
  nanobind::dict values_;
};

}  // namespace fulbito::python
