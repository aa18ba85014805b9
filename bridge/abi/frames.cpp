#include "bridge/abi/frames.hpp"

#include <fmt/format.h>

#include "engine/core/system/error_text.hpp"

namespace fulbito {

std::string failureText(std::string_view reason) {
  constexpr std::size_t kLongest = 2000;
  return terminalText(shortened(reason, kLongest));
}

Result<std::size_t> frameLength(std::string_view received) {
  if (received.size() < sizeof(FrameHeader)) return std::size_t{0};
  FrameHeader header{};
  received.copy(reinterpret_cast<char*>(&header), sizeof header);
  if (header.version != FULBITO_ABI) {
    return fail(ErrorCode::kBadInput, fmt::format("a message has version {} of the interface instead of {}",
                                                  header.version, FULBITO_ABI));
  }
  if (header.size < sizeof header || header.size > kLargestFrame) {
    return fail(ErrorCode::kBadInput, fmt::format("a message has {} bytes; {} to {} are allowed", header.size,
                                                  sizeof header, kLargestFrame));
  }
  return received.size() < header.size ? std::size_t{0} : std::size_t{header.size};
}

Result<FrameReader> FrameReader::open(std::string_view message) {
  const auto length = frameLength(message);
  if (!length) return tl::unexpected<Error>(length.error());
  if (*length == 0 || *length != message.size()) {
    return fail(ErrorCode::kBadInput, fmt::format("{} bytes are not one message", message.size()));
  }
  FrameReader reader;
  reader.rest_ = message;
  reader.take(reader.header_);
  return reader;
}

bool FrameReader::takeText(std::string_view& text) {
  const std::size_t end = rest_.find('\0');
  if (end == std::string_view::npos) return false;
  text = rest_.substr(0, end);
  rest_.remove_prefix(end + 1);
  return true;
}

}  // namespace fulbito
