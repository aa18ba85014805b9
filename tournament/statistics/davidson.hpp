#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace fulbito {

/// Elo per unit of log p: 400 / ln 10.
inline constexpr double kEloPerLog = 173.71779276130073;

/// The matches of two entrants, with weights.
struct WeightedMeeting {
  std::size_t a = 0, b = 0;                      ///< indices of the entrants, a < b
  double wins = 0.0, draws = 0.0, losses = 0.0;  ///< of A
};

/// Davidson's model: P(i beats j) = p_i / (p_i + p_j + nu sqrt(p_i p_j)), P(draw) likewise with nu sqrt(p_i
/// p_j).
struct DavidsonModel {
  std::vector<double> strength;  ///< log p by entrant
  double log_draw = 0.0;         ///< log nu, of no meaning where no match was drawn
};

/// Probabilities of a match's results.
struct MatchChances {
  double win = 0.0, draw = 0.0, loss = 0.0;
};
/// The chances of an entrant whose log p is `lead` greater; `nu` is at least 0.
MatchChances davidsonChances(double lead, double nu);

/// Maximises the likelihood by Newton's method.
class DavidsonFitter {
 public:
  /// @param component  by entrant: mean strength is 0 in each component without a prior
  explicit DavidsonFitter(std::vector<int> component);
  ~DavidsonFitter();
  DavidsonFitter(const DavidsonFitter&) = delete;
  DavidsonFitter& operator=(const DavidsonFitter&) = delete;

  /// Improves `model` until it is within about `accuracy` of the maximum, which must exist (winGraph).
  /// `prior` tells by entrant how many wins, and as many losses, it has against a fictitious entrant of
  /// strength 0; all or none of a component have some.
  void fit(std::span<const WeightedMeeting> meetings, std::span<const double> prior, double accuracy,
           DavidsonModel& model);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
