#include "bridge/lines/match_info_text.hpp"

#include <cmath>

#include "engine/core/base/overloaded.hpp"
#include "engine/core/config/schemas.hpp"
#include "fulbito/detail/lines/json_text.hpp"
#include "referee/rules/rules_schema.hpp"

namespace fulbito::lines {
namespace {

void appendPoint(std::string& out, Vec2 point) {
  out += '[';
  json::append(out, point.x);
  out += ',';
  json::append(out, point.y);
  out += ']';
}

void appendPoints(std::string& out, const std::vector<Vec2>& points) {
  out += '[';
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) out += ',';
    appendPoint(out, points[i]);
  }
  out += ']';
}

void appendValue(std::string& out, const SchemaKey& key) {
  std::visit(Overloaded{[&](const std::string* v) { json::append(out, std::string_view(*v)); },
                        [&](const Label& v) { json::append(out, std::string_view(*v.text)); },
                        [&](const Vec2* v) { appendPoint(out, *v); },
                        [&](const std::vector<Vec2>* v) { appendPoints(out, *v); },
                        [&](const Angle& v) { json::append(out, *v.radians); },
                        [&](const Heading& v) { json::append(out, *v.radians); },
                        [&](const OptionalHeading& v) {
                          v.radians->has_value() ? json::append(out, **v.radians)
                                                 : json::append(out, nullptr);
                        },
                        [&](const Choice& v) {
                          json::append(out, std::string_view(v.names[static_cast<std::size_t>(v.get())]));
                        },
                        [&](const auto* number) { json::append(out, *number); }},
             key.target);
}

void appendKeys(std::string& out, const Schema& schema) {
  for (std::size_t i = 0; i < schema.size(); ++i) {
    if (i > 0) out += ',';
    json::append(out, std::string_view(schema[i].key));
    out += ':';
    appendValue(out, schema[i]);
  }
}

template <typename Table>
void appendTable(std::string& out, std::string_view name, Table table) {
  out += name;
  appendKeys(out, schemaOf(table));
  out += '}';
}

/// The keys of [rules] are members of the object itself, every other table is an object in it.
void appendRules(std::string& out, Rules rules) {
  const auto tables = tablesOf(rules);
  for (std::size_t i = 0; i < tables.size(); ++i) {
    out += i == 0 ? "{" : ",";
    if (i > 0) {
      json::append(out, std::string_view(tables[i].name));
      out += ":{";
    }
    appendKeys(out, tables[i].schema);
    if (i > 0) out += '}';
  }
  out += R"(,"text":)";
  json::append(out, std::string_view(toToml(rules)));
  out += '}';
}

void appendTime(std::string& out, const std::optional<DecisionTime>& time) {
  out += R"(,"decision_time":)";
  if (!time || !std::isfinite(time->decision)) {  // JSON has no infinity
    out += "null";
    return;
  }
  out += R"({"decision":)";
  json::append(out, time->decision);
  out += R"(,"bank":)";
  json::append(out, time->bank);
  out += R"(,"held":)";
  json::append(out, time->held);
  out += '}';
}

}  // namespace

void appendMembers(std::string& out, const MatchInfo& info) {
  out += R"(,"team":)";
  json::append(out, nameOf(info.team));
  out += R"(,"side":)";
  json::append(out, info.side == Side::kLeft ? "left" : "right");
  out += R"(,"dt":)";
  json::append(out, info.dt());
  out += R"(,"team_size":)";
  json::append(out, info.rules.team_size);
  // 64 bits: more than a double holds, and some languages read every number as a double.
  out += R"(,"seed":")";
  json::append(out, info.seed);
  out += R"(","vision":{"age":)";
  json::append(out, info.observation_age);
  out += R"(,"position_noise":)";
  json::append(out, info.position_noise);
  out += R"(,"heading_noise":)";
  json::append(out, info.heading_noise);
  out += R"(,"dropout":)";
  json::append(out, info.dropout);
  out += '}';
  appendTime(out, info.decision_time);
  appendTable(out, R"(,"field":{)", info.field);
  appendTable(out, R"(,"robot":{)", info.robot);
  appendTable(out, R"(,"ball":{)", info.ball);
  appendTable(out, R"(,"physics":{)", info.physics);
  out += R"(,"rules":)";
  appendRules(out, info.rules);
}

}  // namespace fulbito::lines
