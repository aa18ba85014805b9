// Settings of a team: what `name=value` means for each type of parameter. `fulbito/team.hpp` includes this
// after its classes.
#include "fulbito/team.hpp"

// A guard, as `fulbito/team.hpp` includes this before an `#include` of this alone comes here.
#ifndef FULBITO_LIBRARY_SETTINGS_HPP
#define FULBITO_LIBRARY_SETTINGS_HPP

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace fulbito::team {
namespace detail {

/// Value of a flag's text: "true", "on", "1" or their opposites; empty: neither.
inline std::optional<double> flagValue(std::string_view text) {
  if (text == "true" || text == "on" || text == "1") return 1.0;
  if (text == "false" || text == "off" || text == "0") return 0.0;
  return std::nullopt;
}

/// Value of `text` for `parameter`; empty: not one of its values.
inline std::optional<double> valueOf(const Parameter& parameter, std::string_view text) {
  if (parameter.type == Parameter::Type::kFlag) return flagValue(text);
  if (parameter.type == Parameter::Type::kChoice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) return std::nullopt;
    return static_cast<double>(found - parameter.choices.begin());
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = parameter.type != Parameter::Type::kInteger || value == std::floor(value);
  const bool inside = value >= parameter.minimum && value <= parameter.maximum;
  if (code != std::errc{} || end != text.data() + text.size() || !whole || !inside) return std::nullopt;
  return value;
}

/// A number as short text.
inline std::string shortText(double value) {
  char text[32];
  const auto [end, code] = std::to_chars(text, text + sizeof text, value);
  return {text, end};
}

/// The values that `parameter` takes, in words.
inline std::string rangeOf(const Parameter& parameter) {
  if (parameter.type == Parameter::Type::kFlag) return "true or false";
  if (parameter.type == Parameter::Type::kChoice) {
    std::string names;
    for (const std::string& name : parameter.choices) names += (names.empty() ? "" : ", ") + name;
    return "one of " + names;
  }
  return (parameter.type == Parameter::Type::kInteger ? "a whole number from " : "a number from ") +
         shortText(parameter.minimum) + " to " + shortText(parameter.maximum) +
         (parameter.unit.empty() ? "" : " " + parameter.unit);
}

}  // namespace detail

inline std::string Team::set(std::string_view name, std::string_view value) {
  if (name == "navigator" && !default_navigator_.empty()) {
    navigator_ = value;
    return {};
  }
  for (const Parameter& parameter : parameters()) {
    if (parameter.name != name) continue;
    const auto number = detail::valueOf(parameter, value);
    if (!number) {
      return "parameter '" + parameter.name + "': '" + std::string(value) + "' is not " +
             detail::rangeOf(parameter);
    }
    parameter.set(*number);
    return {};
  }
  return "'" + this->name() + "' has no parameter '" + std::string(name) + "'";
}

}  // namespace fulbito::team

#endif  // FULBITO_LIBRARY_SETTINGS_HPP
