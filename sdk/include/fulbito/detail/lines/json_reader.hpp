// A strict reader of JSON text, without a tree and without allocations. For the line protocol of teams.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include "fulbito/detail/lines/utf8.hpp"

namespace fulbito::json {

/// Reads one JSON text (RFC 8259) from front to back; the caller asks for what it expects:
///
///     if (in.enterObject())
///       for (std::string_view name; in.nextMember(name);) name == "x" ? in.number(x) : in.skip();
///     in.end();
///
/// After the first error, every function returns false and reads nothing, so that one check of `ok` at the
/// end is enough. Allocates only for escapes and errors.
class Reader {
 public:
  /// Objects and arrays within each other; deeper texts are errors.
  static constexpr std::size_t kMaxDepth = 32;

  /// The text must outlive the reader.
  explicit Reader(std::string_view text) : text_(text) {}

  /// Enters an object. Then `nextMember` until it returns false.
  bool enterObject() { return enter('{', "not an object"); }
  /// Enters an array. Then `nextItem` until it returns false.
  bool enterArray() { return enter('[', "not a list"); }
  /// Goes to the next member of the object; its value must be read or skipped. The name is valid until then.
  /// @return false after the last member, which leaves the object
  bool nextMember(std::string_view& name) {
    if (!goOn('}')) return false;
    if (peek() != '"') return syntaxError("a name in quotes is expected");
    StringSpan span;
    if (!scanString(span)) return false;
    frames_[depth_ - 1].name = span.raw;
    if (!takeColon()) return false;
    name = span.raw;
    if (span.escaped) {
      unescape(span.raw, name_);
      name = name_;
    }
    return true;
  }
  /// Goes to the next item of the array; it must be read or skipped.
  /// @return false after the last item, which leaves the array
  bool nextItem() {
    if (!goOn(']')) return false;
    ++frames_[depth_ - 1].index;
    return true;
  }

  /// Takes a null if the next value is one.
  bool takeNull() { return !failed() && (space(), text_.substr(at_, 4) == "null") && word("null"); }
  /// Whether the next value is an object. Takes nothing.
  bool atObject() { return !failed() && (space(), peek() == '{'); }
  /// Reads a number; it may have more digits than a double holds.
  bool number(double& into) {
    std::string_view text;
    if (!scanNumber(text)) return false;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), into);
    if (read.ec == std::errc() && std::isfinite(into)) return true;
    if (orderOf(text) > 0) return error("too large for a double");
    into = text.front() == '-' ? -0.0 : 0.0;
    return true;
  }
  /// Reads a whole number between two limits.
  bool integer(std::int64_t& into, std::int64_t least, std::int64_t most) {
    double value = 0.0;
    const std::size_t from = (space(), at_);
    if (!number(value)) return false;
    const std::string_view text = text_.substr(from, at_ - from);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), into);
    const bool plain = read.ec == std::errc() && read.ptr == text.data() + text.size();
    // Some languages write 3.0 for 3.
    constexpr double kExact = 9007199254740992.0;  // 2^53
    const bool whole = std::abs(value) <= kExact && std::trunc(value) == value;
    if (!plain && whole) into = static_cast<std::int64_t>(value);
    if ((plain || whole) && into >= least && into <= most) return true;
    return error("not a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  /// Reads true or false.
  bool boolean(bool& into) {
    if (failed()) return false;
    space();
    into = peek() == 't';
    if (peek() != 't' && peek() != 'f') return error("neither true nor false");
    return word(into ? "true" : "false");
  }
  /// Reads a string and resolves its escapes.
  bool string(std::string& into) {
    StringSpan span;
    if (failed()) return false;
    space();
    if (peek() != '"') return error("not a string");
    if (!scanString(span)) return false;
    unescape(span.raw, into);
    return true;
  }
  /// Skips any value.
  void skip() {
    const std::size_t base = depth_;
    do {
      skipHead();
      for (std::string_view name; !failed() && depth_ > base;) {
        if (frames_[depth_ - 1].close == ']' ? nextItem() : nextMember(name)) break;
      }
    } while (!failed() && depth_ > base);
  }
  /// Checks that nothing but space is left.
  bool end() {
    if (failed()) return false;
    space();
    return at_ == text_.size() || syntaxError("something follows the value");
  }

  /// Records an error at the value that was read last, with its place: "robots[1].left: not a number".
  /// @return false
  bool error(std::string_view what) { return fail(place() + (depth_ > 0 ? ": " : "") + std::string(what)); }
  /// Whether no error has occurred.
  bool ok() const { return error_.empty(); }
  /// The first error; empty: none.
  const std::string& message() const { return error_; }

 private:
  struct Frame {
    char close = '}';
    bool first = true;
    std::string_view name;    ///< name of the present member, with its escapes
    std::int64_t index = -1;  ///< index of the present item
  };
  struct StringSpan {
    std::string_view raw;  ///< between the quotes
    bool escaped = false;
  };

  bool failed() const { return !error_.empty(); }
  bool fail(std::string text) {
    if (error_.empty()) error_ = std::move(text);
    return false;
  }
  bool syntaxError(const char* what) {
    return fail("column " + std::to_string(at_ + 1) + ": " +
                (at_ < text_.size() ? what : "the text ends early"));
  }
  std::string place() const {
    std::string text;
    for (std::size_t i = 0; i < depth_; ++i) {
      const Frame& frame = frames_[i];
      if (frame.close == ']') {
        text += "[" + std::to_string(frame.index) + "]";
      } else {
        text += (i > 0 ? "." : "") + std::string(frame.name.substr(0, 40));
      }
    }
    return text;
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void space() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r'))
      ++at_;
  }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  void digits() {
    while (isDigit(peek())) ++at_;
  }

  bool enter(char open, const char* otherwise) {
    if (failed()) return false;
    space();
    if (peek() != open) return error(otherwise);
    if (depth_ == kMaxDepth) return error("nested too deeply");
    ++at_;
    frames_[depth_++] = Frame{open == '{' ? '}' : ']', true, {}, -1};
    return true;
  }
  /// Goes to the next member or item, or out of the object or array.
  bool goOn(char close) {
    if (failed()) return false;
    Frame& frame = frames_[depth_ - 1];
    space();
    if (peek() == close) {
      ++at_, --depth_;
      return false;
    }
    if (!frame.first) {
      if (peek() != ',') return syntaxError("a comma or a closing bracket is expected");
      ++at_;
      space();
    }
    frame.first = false;
    return true;
  }
  bool takeColon() {
    space();
    if (peek() != ':') return syntaxError("a colon is expected");
    ++at_;
    return true;
  }
  bool word(std::string_view expected) {
    if (text_.substr(at_, expected.size()) != expected) return syntaxError("an unknown word");
    at_ += expected.size();
    return true;
  }
  void skipHead() {
    if (failed()) return;
    space();
    StringSpan span;
    std::string_view text;
    bool truth = false;
    switch (peek()) {
      case '{':
        enterObject();
        return;
      case '[':
        enterArray();
        return;
      case '"':
        scanString(span);
        return;
      case 't':
      case 'f':
        boolean(truth);
        return;
      case 'n':
        word("null");
        return;
      default:
        if (peek() != '-' && !isDigit(peek())) {
          syntaxError("a value is expected");
          return;
        }
        scanNumber(text);
    }
  }

  bool scanNumber(std::string_view& text) {
    if (failed()) return false;
    space();
    const std::size_t from = at_;
    if (peek() == '-') ++at_;
    if (!isDigit(peek())) {
      at_ = from;
      return error("not a number");
    }
    if (peek() == '0') {
      ++at_;
    } else {
      digits();
    }
    if (peek() == '.') {
      ++at_;
      if (!isDigit(peek())) return syntaxError("a digit is expected");
      digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      if (!isDigit(peek())) return syntaxError("a digit is expected");
      digits();
    }
    text = text_.substr(from, at_ - from);
    return true;
  }
  /// The power of ten of the first digit that is not 0: tells numbers that are too large for a double from
  /// those that are too small.
  static std::int64_t orderOf(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789");
    if (first == std::string_view::npos) return std::numeric_limits<std::int64_t>::min();
    const std::size_t point = std::min(digits.find('.'), digits.size());
    auto order = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
    if (e == std::string_view::npos) return order;
    std::string_view power = text.substr(e + 1);
    if (power.front() == '+') power.remove_prefix(1);
    std::int64_t shift = 0;
    const auto read = std::from_chars(power.data(), power.data() + power.size(), shift);
    constexpr std::int64_t kFar = std::int64_t{1} << 40;
    if (read.ec != std::errc()) shift = power.front() == '-' ? -kFar : kFar;
    return order + std::clamp(shift, -kFar, kFar);
  }

  bool scanString(StringSpan& span) {
    const std::size_t from = ++at_;
    while (at_ < text_.size()) {
      const auto byte = static_cast<unsigned char>(text_[at_]);
      if (byte == '"') {
        span.raw = text_.substr(from, at_++ - from);
        return true;
      }
      if (byte < 0x20) return syntaxError("a control character in a string");
      if (byte == '\\') {
        span.escaped = true;
        if (!scanEscape()) return false;
      } else {
        const std::size_t length = byte < 0x80 ? 1 : utf8Length(text_.substr(at_));
        if (length == 0) return syntaxError("not UTF-8");
        at_ += length;
      }
    }
    return syntaxError("");
  }
  bool scanEscape() {
    ++at_;
    if (peek() != 'u') {
      if (at_ >= text_.size() || std::string_view("\"\\/bfnrt").find(peek()) == std::string_view::npos)
        return syntaxError("an unknown escape");
      ++at_;
      return true;
    }
    const std::int32_t unit = hexAt(at_ + 1);
    if (unit < 0) return syntaxError("four hexadecimal digits are expected");
    const bool low = (unit & 0xfc00) == 0xdc00, high = (unit & 0xfc00) == 0xd800;
    const bool pair = high && text_.substr(at_ + 5, 2) == "\\u" && (hexAt(at_ + 7) & 0xfc00) == 0xdc00;
    if (low || (high && !pair)) return syntaxError("half a character");
    at_ += pair ? 11 : 5;
    return true;
  }
  /// Value of four hexadecimal digits; -1 if they are none.
  std::int32_t hexAt(std::size_t at) const {
    if (at + 4 > text_.size()) return -1;
    return hex(text_.substr(at, 4));
  }
  static std::int32_t hex(std::string_view four) {
    std::int32_t value = 0;
    for (const char c : four) {
      const int digit = isDigit(c)             ? c - '0'
                        : c >= 'a' && c <= 'f' ? c - 'a' + 10
                        : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                               : -1;
      if (digit < 0) return -1;
      value = value * 16 + digit;
    }
    return value;
  }

  /// Resolves the escapes of a string that `scanString` has checked.
  static void unescape(std::string_view raw, std::string& into) {
    into.clear();
    for (std::size_t i = 0; i < raw.size();) {
      const std::size_t next = std::min(raw.find('\\', i), raw.size());
      into += raw.substr(i, next - i);
      i = next == raw.size() ? next : next + resolve(raw.substr(next), into);
    }
  }
  /// Appends the character of the escape at the start of `raw`. @return length of the escape
  static std::size_t resolve(std::string_view raw, std::string& into) {
    if (raw[1] != 'u') {
      constexpr std::string_view kNames = "bfnrt", kBytes = "\b\f\n\r\t";
      const std::size_t which = kNames.find(raw[1]);
      into += which == std::string_view::npos ? raw[1] : kBytes[which];
      return 2;
    }
    auto code = static_cast<std::uint32_t>(hex(raw.substr(2, 4)));
    const bool pair = (code & 0xfc00) == 0xd800;
    if (pair)
      code = 0x10000 + ((code & 0x3ff) << 10) + (static_cast<std::uint32_t>(hex(raw.substr(8, 4))) & 0x3ff);
    const auto byte = [&into](std::uint32_t value) { into += static_cast<char>(value); };
    const auto tail = [&](unsigned shift) { byte(0x80 | ((code >> shift) & 0x3f)); };
    if (code < 0x80) {
      byte(code);
    } else if (code < 0x800) {
      byte(0xc0 | (code >> 6)), tail(0);
    } else if (code < 0x10000) {
      byte(0xe0 | (code >> 12)), tail(6), tail(0);
    } else {
      byte(0xf0 | (code >> 18)), tail(12), tail(6), tail(0);
    }
    return pair ? 12 : 6;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::array<Frame, kMaxDepth> frames_{};
  std::string name_;   ///< a member's name without its escapes
  std::string error_;  ///< the first error
};

}  // namespace fulbito::json
