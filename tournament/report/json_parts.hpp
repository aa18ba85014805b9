#pragma once

#include <string>
#include <vector>

#include "fulbito/detail/interval.hpp"
#include "match/report/match_json.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/statistics/sprt.hpp"

/// JSON parts that the reports of tournaments and of tests share.
namespace fulbito {

/// `value`, `low`, `high`; null where one is infinite.
Json intervalJson(const Interval& interval);
/// Ratio, bounds and error rates of a test.
Json sprtJson(const Sprt& sprt);
/// Matches that the machine failed: pair (from 0), leg (1, 2), reason.
Json unplayedJson(const std::vector<UnplayedMatch>& unplayed);
/// Over several lines, those after the first `spaces` further in. Bytes that are no UTF-8 are replaced.
std::string indented(const Json& json, std::size_t spaces);

}  // namespace fulbito
