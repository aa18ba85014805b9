#include "bridge/lines/match_info_text.hpp"

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
void appendTable(std::string& out, Table& table) {
  out += '{';
  appendKeys(out, schemaOf(table));
  out += '}';
}

}  // namespace

void append(std::string& out, FieldGeometry field) { appendTable(out, field); }
void append(std::string& out, RobotModel robot) { appendTable(out, robot); }
void append(std::string& out, BallModel ball) { appendTable(out, ball); }
void append(std::string& out, PhysicsProfile physics) { appendTable(out, physics); }

/// The keys of [rules] are members of the object itself, every other table is an object in it.
void append(std::string& out, Rules rules) {
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

}  // namespace fulbito::lines
