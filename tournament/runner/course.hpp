#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "tournament/runner/runner.hpp"

namespace fulbito {

/// The results of a tournament while they come in, in any order. Not safe to use from several threads.
class Course {
 public:
  explicit Course(const TournamentPlan& plan);

  /// Adds the result of a leg of a known fixture. If the leg already has a result, that one stays.
  void take(std::size_t fixture, std::size_t leg, MatchResult result);
  /// Adds the fixtures that follow from the results so far. Returns whether it added any.
  bool extend();

  const std::vector<Fixture>& fixtures() const { return schedule_.fixtures; }
  /// The result of a leg; null while it is missing.
  const MatchResult* result(std::size_t fixture, std::size_t leg) const;
  /// The sequential test; empty if the plan has none.
  const std::optional<Sprt>& sprt() const { return sprt_; }
  /// Whether the test has a verdict, so that no further match counts.
  bool decided() const { return sprt_ && sprt_->verdict() != SprtVerdict::kInconclusive; }
  /// The state of the tournament, without identities.
  TournamentState state() &&;

 private:
  /// Adds the pairs before the first missing result to the test. The order of the schedule keeps the verdict
  /// independent of timing.
  void judge();

  const TournamentPlan& plan_;
  Schedule schedule_;
  // Pairs of which only one leg has a result.
  std::map<std::size_t, std::array<std::optional<MatchResult>, 2>> halves_;
  FixtureResults results_;
  std::optional<Sprt> sprt_;
  std::size_t judged_ = 0;
};

}  // namespace fulbito
