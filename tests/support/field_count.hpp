#pragma once

#include <cstddef>
#include <utility>

namespace fulbito::test {

/// Converts to the type of any member, so that an aggregate can be asked how many members it takes.
struct AnyMember {
  template <typename T>
  operator T() const;  // NOLINT(google-explicit-constructor): only so does it stand for a member
};

/// How many members the aggregate `T` has (none of them an array): finds a key that a schema forgot.
template <typename T, typename... Members>
constexpr std::size_t fieldCount() {
  if constexpr (requires { T{std::declval<Members>()..., AnyMember{}}; }) {
    return fieldCount<T, Members..., AnyMember>();
  } else {
    return sizeof...(Members);
  }
}

}  // namespace fulbito::test
