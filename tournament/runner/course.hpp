#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "tournament/runner/runner.hpp"

namespace fulbito {

/// The results of a tournament as they come in, in any order. Not safe to use from several threads.
class Course {
 public:
  explicit Course(const TournamentPlan& plan);

  /// Takes the result of a leg of a known fixture; the first one stays.
  void take(std::size_t fixture, std::size_t leg, MatchResult result);
  /// Adds the fixtures that follow from the results so far. Returns whether there are new ones.
  bool extend();

  const std::vector<Fixture>& fixtures() const { return schedule_.fixtures; }
  /// The result of a leg; null while it is missing.
  const MatchResult* result(std::size_t fixture, std::size_t leg) const;
  /// The test, of a plan with one.
  const std::optional<Sprt>& sprt() const { return sprt_; }
  /// Whether the test has a verdict: no further match counts.
  bool decided() const { return sprt_ && sprt_->verdict() != SprtVerdict::kInconclusive; }
  /// Everything so far as a value, without identities.
  TournamentState state() &&;

 private:
  /// Feeds the test with the pairs before the first gap: in the order of the schedule, so that the verdict
  /// does not depend on who is fast.
  void judge();

  const TournamentPlan& plan_;
  Schedule schedule_;
  std::map<std::size_t, std::array<std::optional<MatchResult>, 2>> halves_;  // pairs with one result
  FixtureResults results_;
  std::optional<Sprt> sprt_;
  std::size_t judged_ = 0;
};

}  // namespace fulbito
