#pragma once

#include <cstdint>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "tournament/statistics/ratings.hpp"

namespace fulbito {

/// The run of one navigator on one layout.
struct LayoutRun {
  bool arrived = false;  ///< reached the goal without a contact that the suite forbids
  double time = 0.0;     ///< [s] until arrival
  double length = 0.0;   ///< [m] of the driven path
};
/// Runs as [navigator][layout]; all navigators drive the same layouts.
using LayoutRuns = std::vector<std::vector<LayoutRun>>;

/// Points of the first run against the second on the same layout. 1 if only the first arrived or is faster by
/// more than `tie` [s]; 0 the other way round; else 1/2.
double pointsOfRun(const LayoutRun& first, const LayoutRun& second, double tie);

/// One navigator in the table.
struct NavigatorStanding {
  std::size_t navigator = 0;         ///< index in the configuration
  Interval elo;                      ///< see Ratings
  Interval arrived;                  ///< share of layouts on which it arrived, with Wilson's interval
  int won = 0, drawn = 0, lost = 0;  ///< layouts, summed over all opponents
  double time = 0.0;                 ///< [s] mean over `NavigatorTable::common` layouts; NaN without any
  double length = 0.0;               ///< [m] mean over the same layouts; NaN without any
};

/// One navigator against another on the same layouts.
struct NavigatorMeeting {
  std::size_t first = 0, second = 0;  ///< indices in the configuration, the higher-ranked first
  int won = 0, drawn = 0, lost = 0;   ///< layouts
  double superiority = 0.5;           ///< probability that the first is the stronger one
  double p = 1.0;                     ///< exact two-sided sign test of equal strength; draws do not count
  double p_holm = 1.0;                ///< `p` with Holm's correction for all meetings of the tournament
  int both = 0;                       ///< layouts on which both arrived
  Interval time;    ///< [s] mean difference first - second over those layouts; Student's t interval
  Interval length;  ///< [m] the same for the driven path
};

/// The outcome of a tournament of navigators.
struct NavigatorTable {
  std::vector<NavigatorStanding> standings;  ///< by Elo, best first
  /// Every two navigators, sorted by standing of the first, then of the second.
  std::vector<NavigatorMeeting> meetings;
  int layouts = 0;
  int common = 0;           ///< layouts on which all arrived
  double draw_share = 0.0;  ///< see Ratings
  bool prior = false;       ///< see Ratings
};

/// Computes the table. Intervals and tests treat layouts as independent units; times within `tie` [s] are
/// drawn.
NavigatorTable navigatorTable(const LayoutRuns& runs, double tie, std::uint64_t seed);

}  // namespace fulbito
