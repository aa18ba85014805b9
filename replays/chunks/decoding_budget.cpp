#include "replays/chunks/decoding_budget.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr std::uint64_t kRows = 4'000'000, kRowsPerByte = 64;
constexpr std::uint64_t kStarts = 250'000, kStartsPerByte = 4;
constexpr std::uint64_t kListBytes = 1'000'000, kListBytesPerByte = 100;
constexpr std::uint64_t kPlays = 2'000, kBytesPerPlay = 8;
constexpr std::uint64_t kEvents = 20'000, kBytesPerEvent = 16;
constexpr std::uint64_t kDrawings = 100'000, kDrawingsPerByte = 1;

/// Takes `amount` off `left`. False if `left` is too small.
bool spend(std::uint64_t& left, std::uint64_t amount) {
  if (amount > left) return false;
  left -= amount;
  return true;
}

}  // namespace

DecodingBudget::DecodingBudget(std::size_t file_bytes)
    : rows_(kRows + kRowsPerByte * file_bytes),
      starts_(kStarts + kStartsPerByte * file_bytes),
      list_bytes_(kListBytes + kListBytesPerByte * file_bytes),
      plays_(kPlays + file_bytes / kBytesPerPlay),
      events_(kEvents + file_bytes / kBytesPerEvent),
      drawings_(kDrawings + kDrawingsPerByte * file_bytes) {}

std::optional<std::string> DecodingBudget::take(const ChunkHead& head, BytesView payload,
                                                const RecordingHeader& header) {
  const std::uint64_t bodies = std::max<std::size_t>(header.bodies.size(), 1);
  const char* what = nullptr;
  if (!spend(rows_, bodies * static_cast<std::uint64_t>(head.ticks))) {
    what = "ticks";
  } else if (!spend(starts_, bodies * static_cast<std::uint64_t>(head.plays)) ||
             !spend(plays_, static_cast<std::uint64_t>(head.plays))) {
    what = "plays";
  } else if (!spend(list_bytes_, listBytes(payload, header))) {
    what = "plays, events and drawings";
  } else if (!spend(events_, head.events)) {
    what = "events";
  } else if (!spend(drawings_, head.drawings)) {
    what = "drawings";
  }
  if (what == nullptr) return std::nullopt;
  return fmt::format("more {} than a file of this size can hold", what);
}

}  // namespace fulbito
