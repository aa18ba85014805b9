#include "engine/core/config/schema.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/overloaded.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = math::kPi / 180.0;
constexpr std::size_t kMaxWaypoints = 1000;

bool within(double value, double minimum, double maximum) { return value >= minimum && value <= maximum; }

std::string limits(double minimum, double maximum, const std::string& unit) {
  return fmt::format("{:.6g} ... {:.6g}{}{}", minimum, maximum, unit.empty() ? "" : " ", unit);
}

FlawText checkRadians(double value, const SchemaKey& key) {
  return checkNumber(value, key.minimum * kDegree, key.maximum * kDegree, "rad");
}

FlawText checkPoint(Vec2 point, const SchemaKey& key) {
  if (within(point.x, key.minimum, key.maximum) && within(point.y, key.minimum, key.maximum)) {
    return std::nullopt;
  }
  return fmt::format("= [{}, {}] is outside {}", point.x, point.y,
                     limits(key.minimum, key.maximum, key.unit));
}

FlawText checkPath(const std::vector<Vec2>& path, const SchemaKey& key) {
  if (path.size() > kMaxWaypoints) {
    return fmt::format("has {} waypoints; at most {} are allowed", path.size(), kMaxWaypoints);
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (const FlawText flaw = checkPoint(path[i], key)) return fmt::format("[{}] {}", i, *flaw);
  }
  return std::nullopt;
}

FlawText checkText(const std::string& text, const SchemaKey& key) {
  const bool control = std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  });
  if (within(static_cast<double>(text.size()), key.minimum, key.maximum) && !control) return std::nullopt;
  return fmt::format("= \"{}\" must have {} characters, none of them a control character", printable(text),
                     limits(key.minimum, key.maximum, ""));
}

FlawText checkLabel(const std::string& text, const SchemaKey& key) {
  if (text.find_first_of("/\\") == std::string::npos && !text.starts_with('.')) return checkText(text, key);
  return fmt::format("= \"{}\" must not contain slashes or begin with a dot", printable(text));
}

}  // namespace

FlawText checkNumber(double value, double minimum, double maximum, const std::string& unit) {
  if (within(value, minimum, maximum)) return std::nullopt;
  return fmt::format("= {} is outside {}", value, limits(minimum, maximum, unit));
}

FlawText checkValue(const SchemaKey& key) {
  return std::visit(
      Overloaded{[&](const double* v) { return checkNumber(*v, key.minimum, key.maximum, key.unit); },
                 [&](const int* v) { return checkNumber(*v, key.minimum, key.maximum, key.unit); },
                 [](const bool*) { return FlawText(); },
                 [&](const std::string* v) { return checkText(*v, key); },
                 [&](const Label& v) { return checkLabel(*v.text, key); },
                 [&](const Vec2* v) { return checkPoint(*v, key); },
                 [&](const std::vector<Vec2>* v) { return checkPath(*v, key); },
                 [&](const Angle& v) { return checkRadians(*v.radians, key); },
                 [&](const Heading& v) { return checkRadians(*v.radians, key); },
                 [&](const OptionalHeading& v) {
                   return v.radians->has_value() ? checkRadians(**v.radians, key) : FlawText();
                 },
                 [](const Choice&) { return FlawText(); }},
      key.target);
}

std::string Flaw::message() const {
  const std::string place = index < 0 ? table : fmt::format("{}[{}]", table, index);
  if (key.empty()) return fmt::format("{} {}", place, text);
  // "path[3] = ..." names an element of the value: no space before it.
  return fmt::format("{}.{}{}{}", place, key, text.starts_with('[') ? "" : " ", text);
}

std::optional<Flaw> rangeFlaw(const Schema& schema, const std::string& table, int index) {
  for (const SchemaKey& key : schema) {
    if (const FlawText flaw = checkValue(key)) return Flaw{table, index, key.key, *flaw};
  }
  return std::nullopt;
}

Result<void> asResult(const std::optional<Flaw>& flaw) {
  if (flaw) return fail(ErrorCode::kBadInput, flaw->message());
  return {};
}

std::string valueText(const SchemaKey& key) {
  const auto point = [](Vec2 p) { return fmt::format("[{}, {}]", tomlNumber(p.x), tomlNumber(p.y)); };
  return std::visit(
      Overloaded{[](const double* v) { return tomlNumber(*v); },
                 [](const int* v) { return fmt::format("{}", *v); },
                 [](const bool* v) { return std::string(*v ? "true" : "false"); },
                 [](const std::string* v) { return tomlString(*v); },
                 [](const Label& v) { return tomlString(*v.text); }, [&](const Vec2* v) { return point(*v); },
                 [&](const std::vector<Vec2>* v) {
                   std::vector<std::string> points;
                   for (Vec2 p : *v) points.push_back(point(p));
                   return fmt::format("[{}]", fmt::join(points, ", "));
                 },
                 [](const Angle& v) { return tomlNumber(*v.radians); },
                 [](const Heading& v) { return tomlNumber(*v.radians); },
                 [](const OptionalHeading& v) {
                   return v.radians->has_value() ? tomlNumber(**v.radians) : std::string();
                 },
                 [](const Choice& v) { return tomlString(v.names[static_cast<std::size_t>(v.get())]); }},
      key.target);
}

std::string tableText(const Schema& schema, bool comments) {
  std::string text;
  for (const SchemaKey& key : schema) {
    const std::string value = valueText(key);
    if (value.empty()) continue;
    text += fmt::format("{} = {}", key.key, value);
    if (comments) {
      const std::string unit = isAngle(key) ? "rad" : key.unit;
      text += fmt::format("  # {}{}", unit.empty() ? "" : "[" + unit + "] ", key.doc);
    }
    text += '\n';
  }
  return text;
}

bool isAngle(const SchemaKey& key) {
  return std::holds_alternative<Angle>(key.target) || std::holds_alternative<Heading>(key.target) ||
         std::holds_alternative<OptionalHeading>(key.target);
}

}  // namespace fulbito
