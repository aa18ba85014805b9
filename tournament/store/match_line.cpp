#include "tournament/store/match_line.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/system/error_text.hpp"
#include "tournament/store/row_keys.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string hexText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

bool isPlain(char c) { return c >= 0x20 && c < 0x7f; }

std::string storedText(const std::string& text) {
  if (text.size() <= kLongestRowText && std::all_of(text.begin(), text.end(), isPlain)) return text;
  // Encodes and parses the text, because only the JSON library determines which invalid bytes it replaces.
  return shortened(Json::parse(dumped(text)).get<std::string>(), kLongestRowText);
}

Json playJson(const TeamRecord& record) {
  Json json = Json::array();
  for (const auto count : kPlayCounts) json.push_back(record.*count);
  return json;
}

Json faultsJson(const TeamFaults& faults) {
  Json json = Json::object();
  for (const row::FaultCount& entry : row::kCounts) {
    if (const std::int64_t count = faults.*entry.count; count != 0) json[entry.key] = count;
  }
  if (!faults.failure.empty()) json[row::kFailure] = faults.failure;
  if (faults.forfeited) json[row::kForfeited] = true;
  return json;
}

Json rowJson(const MatchRow& row) {
  const MatchResult& result = row.result;
  Json json{
      {row::kKeys[row::kId], row.id.text()},
      {row::kKeys[row::kTeamNames], row.teams},
      {row::kKeys[row::kStart], row.start},
      {row::kKeys[row::kSeed], row.seed},
      {row::kKeys[row::kScore], result.score},
      {row::kKeys[row::kWinner], result.winner ? Json(nameOf(*result.winner)) : Json(nullptr)},
      {row::kKeys[row::kGoalsAfterFoul], result.goals_after_foul},
      {row::kKeys[row::kPlayTicks], result.play.play_ticks},
      {row::kKeys[row::kWallTicks], result.play.wall_ticks},
      {row::kKeys[row::kCornerTicks], result.play.corner_ticks},
      {row::kKeys[row::kPlay], {playJson(result.play.teams[0]), playJson(result.play.teams[1])}},
      {row::kKeys[row::kTicks], result.ticks},
      {row::kKeys[row::kHash], hexText(result.hash)},
      {row::kKeys[row::kOutcome], nameOf(result.outcome)},
      {row::kKeys[row::kFaults], {faultsJson(result.faults.teams[0]), faultsJson(result.faults.teams[1])}}};
  if (result.faults.abandoned) json[row::kKeys[row::kAbandoned]] = result.faults.abandoned->message;
  return json;
}

}  // namespace

std::string_view logHeader() {
  static const std::string header =
      dumped(Json{{"schema_version", kMatchLogVersion}, {"content", "matches"}}) + '\n';
  return header;
}

MatchRow storedForm(MatchRow row) {
  for (std::string& name : row.teams) name = storedText(name);
  row.start = storedText(row.start);
  MatchFaults& faults = row.result.faults;
  for (TeamFaults& team : faults.teams) team.failure = storedText(team.failure);
  if (faults.abandoned) faults.abandoned = Error{ErrorCode::kBadInput, storedText(faults.abandoned->message)};
  return row;
}

bool sameResult(const MatchResult& a, const MatchResult& b) {
  const auto values = [](const MatchResult& r) {
    return std::tie(r.score, r.winner, r.goals_after_foul, r.play.play_ticks, r.play.wall_ticks,
                    r.play.corner_ticks, r.ticks, r.hash, r.outcome);
  };
  const auto same_play = [](const TeamRecord& x, const TeamRecord& y) {
    return std::all_of(std::begin(kPlayCounts), std::end(kPlayCounts),
                       [&](const auto count) { return x.*count == y.*count; });
  };
  const auto same_faults = [](const TeamFaults& x, const TeamFaults& y) {
    return x.forfeited == y.forfeited &&
           std::all_of(std::begin(row::kCounts), std::end(row::kCounts),
                       [&](const row::FaultCount& c) { return x.*c.count == y.*c.count; });
  };
  return values(a) == values(b) &&
         std::equal(a.play.teams.begin(), a.play.teams.end(), b.play.teams.begin(), same_play) &&
         std::equal(a.faults.teams.begin(), a.faults.teams.end(), b.faults.teams.begin(), same_faults) &&
         a.faults.abandoned.has_value() == b.faults.abandoned.has_value();
}

std::string toLine(const MatchRow& row) {
  std::string line = dumped(rowJson(storedForm(row)));
  line.pop_back();  // the checksum comes before the last brace
  return fmt::format("{}{}{}{}\n", line, row::kBeforeSum, hexText(row::sumOf(line)), row::kAfterSum);
}

}  // namespace fulbito
