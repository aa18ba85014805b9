#include "bridge/wire/oddities.hpp"

#include <fmt/format.h>

namespace fulbito::wire {
namespace {

constexpr std::int64_t kBetweenLines = 1'000'000'000;  // [ns]

constexpr const char* kWords[kOddities] = {
    "malformed datagram",         "value that is not finite",  "unknown robot",
    "datagram of a flood",        "command of another sender", "replacement, which is the referee's",
    "datagram that was not sent",
};

}  // namespace

void OddityLog::note(Oddity kind, std::string_view detail) {
  const auto index = static_cast<std::size_t>(kind);
  const bool first = counts_[index]++ == 0;
  if (!log_) return;
  const std::int64_t time = clock_();
  if (!first && time - written_at_[index] < kBetweenLines) return;
  written_at_[index] = time;
  log_(fmt::format("{}: {} ({} so far)", kWords[index], detail, counts_[index]));
}

}  // namespace fulbito::wire
