#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tournament/statistics/davidson.hpp"
#include "tournament/statistics/ratings.hpp"

namespace fulbito {

/// One entry for each two entrants that met, in order of a, then b.
using WeightedMeetings = std::vector<WeightedMeeting>;

/// Adds the results of a resample, with random weights of mean 1, to meetings without results.
using Reweigh = std::function<void(Rng&, WeightedMeetings&)>;

/// Ratings of the observed results, with intervals and superiority from `resamples` resamples.
Ratings rateResampled(std::size_t entrants, WeightedMeetings observed, const Reweigh& reweigh,
                      std::uint64_t seed, std::size_t resamples);

}  // namespace fulbito
