#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Numbers as bytes, least significant byte first on every machine.
namespace fulbito {

using Bytes = std::string;
using BytesView = std::string_view;

/// Appends values to a buffer that it does not own.
class ByteWriter {
 public:
  explicit ByteWriter(Bytes& out) : out_(out) {}

  void byte(std::uint8_t value) { out_.push_back(static_cast<char>(value)); }
  template <typename T>
  void fixed(T value) {
    for (std::size_t i = 0; i < sizeof value; ++i) byte(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void number(double value) { fixed(std::bit_cast<std::uint64_t>(value)); }
  /// Seven bits per byte, the lowest first; the highest bit means that more bytes follow.
  void varint(std::uint64_t value) {
    for (; value > 0x7f; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
    byte(static_cast<std::uint8_t>(value));
  }
  /// Few bytes for small absolute values of either sign: 0, -1, 1, -2 ... are written as 0, 1, 2, 3 ...
  void signedVarint(std::int64_t value) {
    varint((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void text(std::string_view value) {
    varint(value.size());
    out_.append(value);
  }

 private:
  Bytes& out_;
};

/// Reads values from the front of a buffer. Past its end, or at a value that is too long, it fails
/// permanently: all later values are 0 or empty. So callers need to check only once, at the end.
class ByteReader {
 public:
  explicit ByteReader(BytesView bytes) : left_(bytes) {}

  bool good() const { return good_; }
  bool atEnd() const { return left_.empty(); }
  std::size_t left() const { return left_.size(); }
  void fail() {
    good_ = false;
    left_ = {};
  }

  BytesView bytes(std::size_t count) {
    if (count > left_.size()) {
      fail();
      return {};
    }
    const BytesView taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }
  std::uint8_t byte() {
    const BytesView one = bytes(1);
    return one.empty() ? 0 : static_cast<std::uint8_t>(one.front());
  }
  template <typename T>
  T fixed() {
    T value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i) value = static_cast<T>(value | T{byte()} << (8 * i));
    return value;
  }
  double number() { return std::bit_cast<double>(fixed<std::uint64_t>()); }
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t next = byte();
      value |= std::uint64_t{next & 0x7fu} << shift;
      if ((next & 0x80) == 0) return value;
    }
    fail();
    return 0;
  }
  /// A varint of at most `most`; a larger one is a failure.
  std::uint64_t varint(std::uint64_t most) {
    const std::uint64_t value = varint();
    if (value <= most) return value;
    fail();
    return 0;
  }
  std::int64_t signedVarint() {
    const std::uint64_t value = varint();
    return static_cast<std::int64_t>((value >> 1) ^ (~(value & 1) + 1));
  }
  BytesView text() { return bytes(static_cast<std::size_t>(varint(left_.size()))); }
  /// A text of at most `most` bytes; a longer one is a failure.
  BytesView text(std::size_t most) { return bytes(static_cast<std::size_t>(varint(most))); }

 private:
  BytesView left_;
  bool good_ = true;
};

}  // namespace fulbito
