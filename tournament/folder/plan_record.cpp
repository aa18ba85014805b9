#include "tournament/folder/plan_record.hpp"

#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tournament/folder/json_changes.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

/// A time limit as JSON, which has no number for infinity.
Json timeJson(double seconds) {
  return seconds == std::numeric_limits<double>::infinity() ? Json("unlimited") : Json(seconds);
}

double timeOf(const Json& json) {
  return json.is_string() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

Json visionJson(const VisionModel& vision) {
  return {{"latency_ticks", vision.latency_ticks},
          {"position_noise", vision.position_noise},
          {"heading_noise", vision.heading_noise},
          {"dropout", vision.dropout}};
}

VisionModel visionOf(const Json& json) {
  VisionModel vision;
  vision.latency_ticks = json.at("latency_ticks").get<int>();
  vision.position_noise = json.at("position_noise").get<double>();
  vision.heading_noise = json.at("heading_noise").get<double>();
  vision.dropout = json.at("dropout").get<double>();
  return vision;
}

Json decisionTimeJson(const DecisionTime& time) {
  return {{"decision_s", timeJson(time.decision)},
          {"bank_s", time.bank},
          {"held", time.held},
          {"start_s", time.start},
          {"failures", time.failures}};
}

DecisionTime decisionTimeOf(const Json& json) {
  DecisionTime time;
  time.decision = timeOf(json.at("decision_s"));
  time.bank = json.at("bank_s").get<double>();
  time.held = json.at("held").get<int>();
  time.start = json.at("start_s").get<double>();
  time.failures = json.at("failures").get<int>();
  return time;
}

Json matchJson(const MatchConfig& match) {
  Json json{{"rules", toToml(match.rules)},
            {"field", toToml(match.field)},
            {"robot", toToml(match.robot)},
            {"physics", toToml(match.physics)},
            {"vision_first", visionJson(match.vision[0])},
            {"vision_others", visionJson(match.vision[1])},
            {"placement_error", {match.placement_error.position, match.placement_error.heading}}};
  if (match.decision_time) json["decision_time"] = decisionTimeJson(*match.decision_time);
  if (match.start) json["start"] = toToml(StartState{*match.start, match.scoreboard});
  return json;
}

Json startsJson(const BookConfig& book) {
  Json kinds = Json::array();
  for (const StartKind kind : book.kinds) kinds.push_back(nameOf(kind));
  return {{"kinds", kinds}, {"seed", book.seed}};
}

Json planJson(const TournamentPlan& plan) {
  Json json{{"name", plan.name},
            {"format", nameOf(plan.format)},
            {"pairs", plan.pairs},
            {"rounds", plan.rounds},
            {"groups", plan.groups},
            {"seed", plan.seed},
            {"starts", startsJson(plan.book)},
            {"entrants", Json::array()}};
  for (const Entrant& entrant : plan.entrants) {
    Json one{{"name", entrant.name}, {"team", entrant.team.text}};
    if (!entrant.files.empty()) one["files"] = entrant.files;
    json["entrants"].push_back(std::move(one));
  }
  if (plan.sprt) {
    json["sprt"] = {{"weak", plan.sprt->weak},
                    {"strong", plan.sprt->strong},
                    {"alpha", plan.sprt->alpha},
                    {"beta", plan.sprt->beta}};
  }
  json["match"] = matchJson(plan.match);
  return json;
}

Json identityJson(const MatchIdentity& identity) {
  Json teams = Json::array();
  for (const TeamIdentity& team : identity.teams()) {
    teams.push_back({{"hash", team.hash},
                     {"outside", team.outside},
                     {"deterministic", team.deterministic},
                     {"covers", team.covers}});
  }
  return {{"engine", identity.engine()}, {"matches", identity.base()}, {"teams", teams}};
}

template <typename T>
Result<void> into(T& target, Result<T> value) {
  if (!value) return tl::unexpected<Error>(value.error());
  target = std::move(*value);
  return {};
}

Result<void> readMatch(const Json& json, const std::string& origin, MatchConfig& match) {
  const auto text = [&json](const char* key) { return json.at(key).get<std::string>(); };
  for (const auto& read : {into(match.rules, parseRules(text("rules"), origin)),
                           into(match.field, parseField(text("field"), origin)),
                           into(match.robot, parseRobot(text("robot"), origin)),
                           into(match.physics, parsePhysics(text("physics"), origin))}) {
    if (!read) return read;
  }
  match.vision = {visionOf(json.at("vision_first")), visionOf(json.at("vision_others"))};
  match.placement_error = {json.at("placement_error").at(0).get<double>(),
                           json.at("placement_error").at(1).get<double>()};
  if (json.contains("decision_time")) match.decision_time = decisionTimeOf(json["decision_time"]);
  if (json.contains("start")) {
    auto start = parseStartState(text("start"), origin);
    if (!start) return tl::unexpected<Error>(start.error());
    match.start = start->placement;
    match.scoreboard = start->scoreboard;
  }
  return {};
}

template <typename T>
T named(std::optional<T> value) {
  if (!value) throw std::invalid_argument("a name is unknown");
  return *value;
}

Result<TournamentPlan> readPlan(const Json& json, const std::string& origin) {
  TournamentPlan plan;
  plan.name = json.at("name").get<std::string>();
  plan.format = named(formatOf(json.at("format").get<std::string>()));
  plan.pairs = json.at("pairs").get<int>();
  plan.rounds = json.at("rounds").get<int>();
  plan.groups = json.at("groups").get<int>();
  plan.seed = json.at("seed").get<std::uint64_t>();
  plan.book.kinds.clear();
  for (const Json& kind : json.at("starts").at("kinds")) {
    plan.book.kinds.push_back(named(startKindOf(kind.get<std::string>())));
  }
  plan.book.seed = json.at("starts").at("seed").get<std::uint64_t>();
  for (const Json& entrant : json.at("entrants")) {
    Entrant read;
    read.name = entrant.at("name").get<std::string>();
    read.team.text = entrant.at("team").get<std::string>();
    if (entrant.contains("files")) read.files = entrant["files"].get<std::vector<std::string>>();
    plan.entrants.push_back(std::move(read));
  }
  if (json.contains("sprt")) {
    const Json& test = json["sprt"];
    plan.sprt = SprtBounds{test.at("weak").get<double>(), test.at("strong").get<double>(),
                           test.at("alpha").get<double>(), test.at("beta").get<double>()};
  }
  if (auto read = readMatch(json.at("match"), origin, plan.match); !read) {
    return tl::unexpected<Error>(read.error());
  }
  return plan;
}

Result<MatchIdentity> readIdentity(const Json& json, const TournamentPlan& plan) {
  std::vector<TeamIdentity> teams;
  for (const Json& team : json.at("teams")) {
    TeamIdentity read;
    read.hash = team.at("hash").get<std::string>();
    read.outside = team.at("outside").get<bool>();
    read.deterministic = team.at("deterministic").get<bool>();
    read.covers = team.at("covers").get<std::string>();
    teams.push_back(std::move(read));
  }
  return MatchIdentity::restore(plan, json.at("engine").get<std::string>(),
                                json.at("matches").get<std::string>(), std::move(teams));
}

}  // namespace

std::string toJson(const PlanRecord& record) {
  Json json{{"schema_version", kSchemaVersion}, {"plan", planJson(record.plan)}};
  json["identity"] = identityJson(record.identity);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<PlanRecord> parsePlanRecord(std::string_view text, const std::string& origin) {
  try {
    const Json json = Json::parse(text);
    if (json.at("schema_version") != kSchemaVersion) {
      return fail(ErrorCode::kBadInput, origin + ": written by another version of this program");
    }
    auto plan = readPlan(json.at("plan"), origin);
    if (!plan) return tl::unexpected<Error>(plan.error());
    auto identity = readIdentity(json.at("identity"), *plan);
    if (!identity) return tl::unexpected<Error>(identity.error());
    for (const auto& checked : {validate(*plan), validateFormat(*plan), validate(plan->book)}) {
      if (!checked) return fail(ErrorCode::kBadInput, origin + ": " + checked.error().message);
    }
    return PlanRecord{std::move(*plan), std::move(*identity)};
  } catch (const std::exception& error) {  // from the JSON library, or an unknown name
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: not the plan of a tournament: {}", origin, error.what()));
  }
}

std::vector<std::string> changesOf(const TournamentPlan& before, const TournamentPlan& after) {
  return changesOf(planJson(before), planJson(after));
}

std::vector<std::string> changesOf(const PlanRecord& before, const PlanRecord& after) {
  std::vector<std::string> changes;
  if (before.identity.engine() != after.identity.engine()) changes.emplace_back("the engine has changed");
  for (std::size_t i = 0; i < after.plan.entrants.size() && i < before.identity.teams().size(); ++i) {
    if (before.identity.teams()[i].hash != after.identity.teams()[i].hash) {
      changes.push_back(after.plan.entrants[i].name + " has changed");
    }
  }
  return changes;
}

}  // namespace fulbito
