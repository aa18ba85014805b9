#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fulbito {

/// Keeps the first 64 KiB of a stream and counts the rest.
class ErrorsKept {
 public:
  static constexpr std::size_t kMost = 65536;  ///< [bytes]

  ErrorsKept() { text_.reserve(kMost); }
  /// Keeps as many bytes as there is room for.
  void add(std::string_view bytes);
  /// The kept text, with a line about the rest if there is one. Starts anew.
  std::string take();

 private:
  std::string text_;
  std::size_t left_out_ = 0;
};

}  // namespace fulbito
