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
  kKickOff,   ///< the kick-off of the rules
  kFreeBall,  ///< at one of the four free-ball marks
  kPenalty,
  kGoalKick,
  kPlay  ///< a state from the middle of play
};
inline constexpr std::size_t kStartKinds = 5;
/// "kick-off", "free-ball", "penalty", "goal-kick", "play".
std::string_view nameOf(StartKind kind);
/// The kind with this name, if any.
std::optional<StartKind> startKindOf(std::string_view name);

/// A book of starts. This configuration and the number of a start determine the start.
struct BookConfig {
  /// Starts take turns through these; each kind at most once.
  std::vector<StartKind> kinds{StartKind::kKickOff};
  std::uint64_t seed = 1;
};

/// One start of a book.
struct BookEntry {
  StartKind kind = StartKind::kKickOff;
  std::string name;  ///< unique in the book: "kick-off:0", "free-ball:17"
};

/// Kind and name of start number `index`, without computing the start itself.
BookEntry bookEntry(const BookConfig& book, std::size_t index);

/// What determines a start, given the match and this program. A start has the same key in every book.
struct StartKey {
  StartKind kind = StartKind::kKickOff;
  std::uint64_t seed = 0;  ///< seed of the book; 0 for a start that does not depend on it
  /// Number of the start among those of its kind; 0 for a start that does not depend on it.
  std::uint64_t turn = 0;
};
/// The key of start number `index`, without computing the start itself.
StartKey startKey(const BookConfig& book, std::size_t index);

/// Begins `match` with start number `index`: sets its opening or its placement; score and clock stay. A
/// kick-off changes nothing. Both matches of a pair get the same start in the world frame, so each team plays
/// each side of it once. Errors: kUsage as `validate`, and if `match` already has a start state while the
/// book has more than kick-offs; as `Match::create`; kBadInput when rules or field do not allow the start.
Result<void> applyStart(const BookConfig& book, std::size_t index, MatchConfig& match);

/// Checks that the book lists at least one kind and none twice. Errors: kUsage.
Result<void> validate(const BookConfig& book);

}  // namespace fulbito
