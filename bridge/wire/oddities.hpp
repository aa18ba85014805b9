#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace fulbito::wire {

/// What is wrong with datagrams, or parts of them, that do nothing.
enum class Oddity : std::uint8_t {
  kMalformed,    ///< no message of the protocol, or too long
  kNotFinite,    ///< a command or pose with a NaN or an infinity
  kUnknown,      ///< a robot that there is not
  kFlood,        ///< beyond what one sender may send per frame
  kOtherSender,  ///< of a sender other than the first, if the server is locked to that
  kReplacement,  ///< a wish to move robots or ball where only the referee may
  kUnsent        ///< the system did not send a datagram of ours
};
inline constexpr std::size_t kOddities = static_cast<std::size_t>(Oddity::kUnsent) + 1;

/// Takes lines for people, without their ends.
using WireLog = std::function<void(std::string_view line)>;
/// Monotonic time [ns].
using WireClock = std::function<std::int64_t()>;

/// Counts oddities, and writes at most one line per kind and second about them.
class OddityLog {
 public:
  OddityLog(WireClock clock, WireLog log) : clock_(std::move(clock)), log_(std::move(log)) {}

  /// @param detail  about this one, for the line
  void note(Oddity kind, std::string_view detail);
  /// All of that kind so far.
  std::uint64_t count(Oddity kind) const { return counts_[static_cast<std::size_t>(kind)]; }

 private:
  WireClock clock_;
  WireLog log_;
  std::array<std::uint64_t, kOddities> counts_{};
  std::array<std::int64_t, kOddities> written_at_{};  ///< [ns]
};

}  // namespace fulbito::wire
