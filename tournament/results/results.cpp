#include "tournament/results/results.hpp"

#include <charconv>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr std::string_view kOutcomes[] = {"normal", "mercy", "slow", "illegal", "crash", "forfeit"};
constexpr std::size_t kWordDigits = 16;

}  // namespace

std::string_view nameOf(MatchOutcome outcome) { return kOutcomes[static_cast<std::size_t>(outcome)]; }

std::optional<MatchOutcome> outcomeOf(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kOutcomes); ++i) {
    if (kOutcomes[i] == name) return static_cast<MatchOutcome>(i);
  }
  return std::nullopt;
}

std::string MatchId::text() const { return fmt::format("{:016x}{:016x}", words[0], words[1]); }

std::optional<MatchId> MatchId::parse(std::string_view text) {
  MatchId id;
  if (text.size() != kWordDigits * id.words.size()) return std::nullopt;
  for (std::size_t i = 0; i < id.words.size(); ++i) {
    const std::string_view digits = text.substr(i * kWordDigits, kWordDigits);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), id.words[i], 16);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return std::nullopt;
  }
  // A different spelling of the same number, such as capital letters, is invalid.
  return id.text() == text ? std::optional(id) : std::nullopt;
}

double PairResult::pointsOfLeg(std::size_t leg) const {
  if (!legs[leg].winner) return 0.5;
  return *legs[leg].winner == kTeams[leg] ? 1.0 : 0.0;
}

}  // namespace fulbito
