#include "navigation/library/plugin_parameters.hpp"

#include <cmath>

#include <fmt/format.h>

#include "navigation/interface/parameters.hpp"

namespace fulbito {
namespace {

constexpr std::uint32_t kMost = 256;  // greatest number of parameters, and of choices of one parameter

std::string textOf(const char* text) { return text == nullptr ? "" : text; }

bool takeChoices(const fulbito_parameter& from, ParameterSpec& spec) {
  if (from.choices == nullptr || from.choice_count == 0 || from.choice_count > kMost) return false;
  for (std::uint32_t i = 0; i < from.choice_count; ++i) {
    if (from.choices[i] == nullptr) return false;
    spec.choices.emplace_back(from.choices[i]);
  }
  spec.minimum = 0.0;
  spec.maximum = static_cast<double>(from.choice_count) - 1.0;
  return true;
}

/// The error in the parameter's specification, or an empty text.
const char* flawOf(const ParameterSpec& spec) {
  if (!std::isfinite(spec.minimum) || !std::isfinite(spec.maximum) || spec.minimum > spec.maximum) {
    return "has no range from a least to a largest value";
  }
  if (!(spec.default_value >= spec.minimum && spec.default_value <= spec.maximum)) {
    return "has a default outside its range";
  }
  if (spec.type != ParameterSpec::Type::kNumber && spec.default_value != std::floor(spec.default_value)) {
    return "has a default that is no whole number";
  }
  return "";
}

Result<ParameterSpec> takeParameter(const fulbito_parameter& from, const std::string& where) {
  const auto bad = [&](const char* what) {
    return fail(ErrorCode::kBadInput, fmt::format("{}: parameter '{}' {}", where, textOf(from.name), what));
  };
  if (textOf(from.name).empty() || textOf(from.name).find_first_of("=,:+") != std::string::npos) {
    return bad("has no proper name");
  }
  if (from.type > FULBITO_CHOICE) return bad("has an unknown type");
  ParameterSpec spec{from.name,          static_cast<ParameterSpec::Type>(from.type),
                     from.default_value, from.minimum,
                     from.maximum,       {},
                     textOf(from.unit),  textOf(from.doc)};
  if (spec.type == ParameterSpec::Type::kFlag) spec.minimum = 0.0, spec.maximum = 1.0;
  if (spec.type == ParameterSpec::Type::kChoice && !takeChoices(from, spec)) return bad("has no choices");
  if (const char* flaw = flawOf(spec); *flaw != '\0') return bad(flaw);
  return spec;
}

}  // namespace

Result<std::vector<ParameterSpec>> pluginParameters(const fulbito_parameter* parameters, std::uint32_t count,
                                                    const std::string& where) {
  if (count > kMost) {
    return fail(ErrorCode::kBadInput, fmt::format("{}: {} parameters; {} are the most", where, count, kMost));
  }
  if (count > 0 && parameters == nullptr) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: no parameters, although it counts {} of them", where, count));
  }
  std::vector<ParameterSpec> specs;
  for (std::uint32_t i = 0; i < count; ++i) {
    auto spec = takeParameter(parameters[i], where);
    if (!spec) return tl::unexpected<Error>(spec.error());
    specs.push_back(std::move(*spec));
  }
  return specs;
}

Result<std::vector<double>> pluginValues(const std::vector<ParameterSpec>& specs,
                                         const std::vector<Setting>& settings, const std::string& owner) {
  std::vector<double> values;
  values.reserve(specs.size());
  for (const ParameterSpec& spec : specs) values.push_back(spec.default_value);
  for (const Setting& setting : settings) {
    const auto index = findParameter(specs, setting.name, owner);
    if (!index) return tl::unexpected<Error>(index.error());
    const auto value = parseParameter(specs[*index], setting.value);
    if (!value) return tl::unexpected<Error>(value.error());
    values[*index] = *value;
  }
  return values;
}

}  // namespace fulbito
