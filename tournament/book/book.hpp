#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/match.hpp"

namespace fulbito {

/// The kinds of starts of a match.
enum class StartKind : std::uint8_t {
  kKickOff,   ///< the rules' own start
  kFreeBall,  ///< at one of the four marks
  kPenalty,
  kGoalKick,
  kPlay  ///< a state from the middle of play
};
inline constexpr std::size_t kStartKinds = 5;
/// "kick-off", "free-ball", "penalty", "goal-kick", "play".
std::string_view nameOf(StartKind kind);
/// The kind of that name, if any.
std::optional<StartKind> startKindOf(std::string_view name);

/// A book of starts: a pure function of this and the number of a start.
struct BookConfig {
  std::vector<StartKind> kinds{StartKind::kKickOff};  ///< they take turns; a kind may be listed once
  std::uint64_t seed = 1;
};

/// One start of a book.
struct BookEntry {
  StartKind kind = StartKind::kKickOff;
  std::string name;  ///< unique in the book: "kick-off:0", "free-ball:17"
};

/// Kind and name of start number `index`, at no cost.
BookEntry bookEntry(const BookConfig& book, std::size_t index);

/// What determines a start, given the match and this program. The same in every book that has the start.
struct StartKey {
  StartKind kind = StartKind::kKickOff;
  std::uint64_t seed = 0;  ///< of the book; 0 where the start does not depend on it
  std::uint64_t turn = 0;  ///< number of the start among those of its kind, likewise
};
/// The key of start number `index`, at no cost.
StartKey startKey(const BookConfig& book, std::size_t index);

/// Begins `match` with that start: sets its opening or its placement; score and clock stay. A kick-off
/// changes nothing. Both matches of a pair get the same start in the world frame, so each team has each side
/// of it once. Errors: kUsage as `validate`, for a match with a start state besides a book of more than
/// kick-offs, and as `Match::create`; kBadInput when rules and field do not allow the start.
Result<void> applyStart(const BookConfig& book, std::size_t index, MatchConfig& match);

/// Checks that kinds are listed, each once. Errors: kUsage.
Result<void> validate(const BookConfig& book);

}  // namespace fulbito
