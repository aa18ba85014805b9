#include "tournament/book/book.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr std::string_view kKinds[] = {"kick-off", "free-ball", "penalty", "goal-kick", "play"};
static_assert(std::size(kKinds) == kStartKinds);

}  // namespace

std::string_view nameOf(StartKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<StartKind> startKindOf(std::string_view name) {
  const auto* const found = std::find(std::begin(kKinds), std::end(kKinds), name);
  if (found == std::end(kKinds)) return std::nullopt;
  return static_cast<StartKind>(found - std::begin(kKinds));
}

BookEntry bookEntry(const BookConfig& book, std::size_t index) {
  const StartKind kind = book.kinds[index % book.kinds.size()];
  return {kind, fmt::format("{}:{}", nameOf(kind), index / book.kinds.size())};
}

StartKey startKey(const BookConfig& book, std::size_t index) {
  const StartKind kind = book.kinds[index % book.kinds.size()];
  if (kind == StartKind::kKickOff) return {kind, 0, 0};
  return {kind, book.seed, index / book.kinds.size()};
}

Result<void> validate(const BookConfig& book) {
  if (book.kinds.empty()) return fail(ErrorCode::kUsage, "the book has no kinds of starts");
  for (auto kind = book.kinds.begin(); kind != book.kinds.end(); ++kind) {
    if (std::find(book.kinds.begin(), kind, *kind) == kind) continue;
    return fail(ErrorCode::kUsage, fmt::format("the book lists '{}' twice", nameOf(*kind)));
  }
  return {};
}

}  // namespace fulbito
