#pragma once

#include <cmath>

#include <nlohmann/json.hpp>

#include "fulbito/detail/build_info.hpp"
#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"

/// JSON parts that summaries and event lines share.
namespace fulbito {

using Json = nlohmann::ordered_json;

/// Version of the objects that `--json` and `--events` print.
inline constexpr int kMatchSchemaVersion = 1;

/// One event; `dt` [s] is the length of a tick.
Json eventJson(const LoggedEvent& event, double dt);
/// The configuration of a match, except its teams and its seed.
Json matchConfigJson(const MatchConfig& config);
Json buildJson(const BuildInfo& build = buildInfo());
/// Score by the teams' colours.
Json scoreJson(const PerTeam<int>& score);
/// JSON has no NaN and no infinity: null means "no value".
inline Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
/// Sixteen hexadecimal digits.
std::string hashText(std::uint64_t hash);

}  // namespace fulbito
