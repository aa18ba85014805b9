#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulbito {

/// Elo per unit of log p: 400 / ln 10.
inline constexpr double kEloPerLog = 173.71779276130073;

/// The weighted results of the matches of two entrants.
struct WeightedMeeting {
  std::size_t a = 0, b = 0;                      ///< indices of the entrants, a < b
  double wins = 0.0, draws = 0.0, losses = 0.0;  ///< results of A
};

/// Davidson's model: P(i beats j) = p_i / (p_i + p_j + nu sqrt(p_i p_j)); P(draw) has the numerator nu
/// sqrt(p_i p_j).
struct DavidsonModel {
  std::vector<double> strength;  ///< log p by entrant
  double log_draw = 0.0;         ///< log nu; has no meaning if no match was drawn
};

/// Probabilities of the results of a match.
struct MatchChances {
  double win = 0.0, draw = 0.0, loss = 0.0;
};
/// Probabilities for an entrant whose log p is `lead` greater than its opponent's; `nu` is at least 0.
MatchChances davidsonChances(double lead, double nu);

/// Fits Davidson's model: maximises its likelihood by Newton's method.
class DavidsonFitter {
 public:
  /// @param component  component by entrant; in each component without a prior, mean strength is 0
  explicit DavidsonFitter(std::vector<int> component);
  ~DavidsonFitter();
  DavidsonFitter(const DavidsonFitter&) = delete;
  DavidsonFitter& operator=(const DavidsonFitter&) = delete;

  /// Improves `model` until it is within about `accuracy` of the maximum, which must exist (`winGraph`).
  /// `prior`, by entrant: number of wins, and as many losses, against a fictitious entrant of strength 0. In
  /// each component, either all entrants have a prior or none.
  void fit(std::span<const WeightedMeeting> meetings, std::span<const double> prior, double accuracy,
           DavidsonModel& model);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
