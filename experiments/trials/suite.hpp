#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/base/result.hpp"
#include "engine/core/models/layout.hpp"
#include "referee/trial/trial_referee.hpp"

namespace fulbito {

/// A family of seeded layouts with the rules for judging their trials.
struct Suite {
  std::string name;
  std::string summary;  ///< one line
  int default_trials = 200;
  std::vector<double> speeds;  ///< [m/s] default top speeds
  ForbiddenContacts forbidden = ForbiddenContacts::kAll;
  double limit_clearance = 0.058;  ///< [m] see TrialConfig
  bool always_drawn = false;       ///< draw every layout, regardless of the configured number
  /// Layout number `index` of a seed: a pure function of the two.
  Layout (*layout)(std::uint64_t seed, std::uint64_t index) = nullptr;
};

/// All suites of layouts: corner, short, close-range, heading, walls, clutter, u-trap, moving and the named
/// cases of the figures of Jung & Lee (2015). `jung-lee-2015` is a comparison made of some of them, see
/// comparison.hpp.
const std::vector<Suite>& suites();

/// Errors: kUsage with a suggestion.
Result<const Suite*> findSuite(const std::string& name);

/// The named cases of Figs 1-8 of Jung & Lee (2015), in order.
const std::vector<Layout>& namedCases();

}  // namespace fulbito
