#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "match/report/match_json.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/statistics/sprt.hpp"

/// JSON parts that the reports of tournaments and of tests share.
namespace fulbito {

/// An interval as an object: `value`, `low`, `high`; infinite ones are null.
Json intervalJson(const Interval& interval);
/// Log-likelihood ratio, bounds and error rates of a sequential test.
Json sprtJson(const Sprt& sprt);
/// Matches left out because the machine failed: pair (from 0), leg (1, 2), reason.
Json unplayedJson(const std::vector<UnplayedMatch>& unplayed);
/// JSON over several lines; lines after the first are indented by `spaces` more. Invalid UTF-8 is replaced.
std::string indented(const Json& json, std::size_t spaces);

}  // namespace fulbito
