#include "match/report/match_json.hpp"

#include <fmt/format.h>

namespace fulbito {
namespace {

Json visionJson(const VisionModel& vision) {
  return {{"latency_ticks", vision.latency_ticks},
          {"noise_m", vision.position_noise},
          {"heading_noise_rad", vision.heading_noise},
          {"dropout", vision.dropout}};
}

}  // namespace

std::string hashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

Json scoreJson(const PerTeam<int>& score) { return {{"blue", score[0]}, {"yellow", score[1]}}; }

Json buildJson(const BuildInfo& build) {
  return {
      {"version", build.version}, {"compiler", build.compiler}, {"type", build.type}, {"box2d", build.box2d}};
}

Json eventJson(const LoggedEvent& event, double dt) {
  const GameEvent& call = event.call;
  Json json = {{"tick", call.tick},
               {"time_s", static_cast<double>(call.tick) * dt},
               {"period", call.period},
               {"play_s", call.play_time}};
  json["event"] = event.restart ? "restart" : std::string(call.clause);
  if (event.restart) json["kind"] = nameOf(*event.restart);
  if (!call.law.empty()) json["law"] = std::string(call.law);
  if (call.team) json["team"] = nameOf(*call.team);
  if (call.robot) json["robot"] = *call.robot;
  json["x"] = call.place.x;
  json["y"] = call.place.y;
  if (!event.restart) {
    json["value"] = call.value;
    json["threshold"] = call.threshold;
    json["margin"] = call.margin;
  }
  json["score"] = {event.score[0], event.score[1]};
  return json;
}

Json matchConfigJson(const MatchConfig& config) {
  return {{"rules", config.rules.name},
          {"field", config.field.name},
          {"physics", config.physics.name},
          {"robot", config.robot.robot.name},
          {"team_size", config.rules.team_size},
          {"half_s", config.rules.half_seconds},
          {"vision", {{"blue", visionJson(config.vision[0])}, {"yellow", visionJson(config.vision[1])}}},
          {"given_start", config.start.has_value()}};
}

}  // namespace fulbito
