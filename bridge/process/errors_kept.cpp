#include "bridge/process/errors_kept.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace fulbito {

void ErrorsKept::add(std::string_view bytes) {
  const std::size_t room = std::min(bytes.size(), kMost - text_.size());
  text_.append(bytes.substr(0, room));
  left_out_ += bytes.size() - room;
}

std::string ErrorsKept::take() {
  std::string text = text_;
  if (left_out_ > 0) {
    text += fmt::format("{}[{} more bytes of standard error]\n", text.ends_with('\n') ? "" : "\n", left_out_);
  }
  text_.clear();
  left_out_ = 0;
  return text;
}

}  // namespace fulbito
