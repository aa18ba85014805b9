#include "tournament/book/book.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "match/config/check_match.hpp"
#include "tournament/book/play_start.hpp"
#include "tournament/book/restart_start.hpp"
#include "tournament/book/sparring.hpp"

namespace fulbito {
namespace {

constexpr std::string_view kKinds[] = {"kick-off", "free-ball", "penalty", "goal-kick", "play"};
static_assert(std::size(kKinds) == kStartKinds);

/// Checks a match with placeholder teams, because the real teams may be chosen later.
Result<void> checkWithoutTeams(MatchConfig match) {
  match.teams = {sparringTeam(), sparringTeam()};
  return checkMatch(match);
}

bool isKickOffsOnly(const BookConfig& book) {
  return book.kinds.size() == 1 && book.kinds.front() == StartKind::kKickOff;
}

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

Result<void> applyStart(const BookConfig& book, std::size_t index, MatchConfig& match) {
  if (auto checked = validate(book); !checked) return checked;
  if ((match.start || match.opening) && !isKickOffsOnly(book)) {
    return fail(ErrorCode::kUsage, "a book of starts and a start state exclude each other");
  }
  const StartKey key = startKey(book, index);
  if (key.kind == StartKind::kKickOff) return {};
  if (auto checked = checkWithoutTeams(match); !checked) return checked;
  if (key.kind == StartKind::kPlay) {
    const auto placement = playStart(key, match);
    if (!placement) return tl::unexpected<Error>(placement.error());
    match.start = *placement;
    return {};
  }
  const auto opening = restartStart(key, match);
  if (!opening) return tl::unexpected<Error>(opening.error());
  match.opening = *opening;
  return {};
}

}  // namespace fulbito
