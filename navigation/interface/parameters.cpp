#include "navigation/interface/parameters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"

namespace fulbito {

Result<double> parseParameter(const ParameterSpec& spec, const std::string& text) {
  if (spec.type == ParameterSpec::Type::kChoice) {
    for (std::size_t i = 0; i < spec.choices.size(); ++i) {
      if (spec.choices[i] == text) return static_cast<double>(i);
    }
    return fail(ErrorCode::kUsage,
                fmt::format("parameter '{}': '{}' is not one of {}.{}", spec.name, text,
                            fmt::join(spec.choices, ", "), suggestion(text, spec.choices)));
  }
  if (spec.type == ParameterSpec::Type::kFlag) {
    if (text == "true" || text == "on" || text == "1") return 1.0;
    if (text == "false" || text == "off" || text == "0") return 0.0;
    return fail(ErrorCode::kUsage, fmt::format("parameter '{}': '{}' is not true or false", spec.name, text));
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = spec.type != ParameterSpec::Type::kInteger || value == std::floor(value);
  if (code != std::errc{} || end != text.data() + text.size() || !whole ||
      !(value >= spec.minimum && value <= spec.maximum)) {
    return fail(ErrorCode::kUsage,
                fmt::format("parameter '{}': '{}' is not {} from {} to {}{}", spec.name, text,
                            spec.type == ParameterSpec::Type::kInteger ? "a whole number" : "a number",
                            spec.minimum, spec.maximum, spec.unit.empty() ? "" : " " + spec.unit));
  }
  return value;
}

Result<std::size_t> findParameter(const std::vector<ParameterSpec>& specs, const std::string& name,
                                  const std::string& owner, const std::vector<std::string>& others) {
  std::vector<std::string> names = others;
  for (std::size_t i = 0; i < specs.size(); ++i) {
    if (specs[i].name == name) return i;
    names.push_back(specs[i].name);
  }
  return fail(ErrorCode::kUsage,
              fmt::format("'{}' has no parameter '{}'.{}", owner, name, suggestion(name, names)));
}

Result<std::vector<Setting>> parseSettings(const std::string& text, const std::string& whole) {
  std::vector<Setting> settings;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0) {
      return fail(ErrorCode::kUsage, fmt::format("'{}' in '{}' is not of the form name=value", item, whole));
    }
    settings.push_back({item.substr(0, equals), item.substr(equals + 1)});
    begin = end + 1;
  }
  return settings;
}

}  // namespace fulbito
