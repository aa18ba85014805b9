#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/navigation.hpp"

namespace fulbito {

/// A parameter and the member of the struct `P` that it sets.
template <typename P>
struct Parameter {
  ParameterSpec spec;                   ///< name, range, unit and documentation
  std::function<void(P&, double)> set;  ///< sets the member to a value of the range
};

/// The parameter that `spec` describes and `member` holds; the struct's initial value is its default.
template <typename P, typename T>
Parameter<P> parameterFor(ParameterSpec spec, T P::* member) {
  spec.default_value = static_cast<double>(P{}.*member);
  return {std::move(spec), [member](P& p, double v) { p.*member = static_cast<T>(v); }};
}

/// A number in `unit` from `minimum` to `maximum`.
template <typename P>
Parameter<P> number(std::string name, double P::* member, double minimum, double maximum, std::string unit,
                    std::string doc) {
  return parameterFor({std::move(name),
                       ParameterSpec::Type::kNumber,
                       0.0,
                       minimum,
                       maximum,
                       {},
                       std::move(unit),
                       std::move(doc)},
                      member);
}
/// A whole number from `minimum` to `maximum`.
template <typename P>
Parameter<P> integer(std::string name, int P::* member, int minimum, int maximum, std::string doc) {
  const double low = minimum, high = maximum;
  return parameterFor(
      {std::move(name), ParameterSpec::Type::kInteger, 0.0, low, high, {}, "", std::move(doc)}, member);
}
/// On or off.
template <typename P>
Parameter<P> flag(std::string name, bool P::* member, std::string doc) {
  return parameterFor({std::move(name), ParameterSpec::Type::kFlag, 0.0, 0.0, 1.0, {}, "", std::move(doc)},
                      member);
}
/// One of `choices`. `E` is an enum whose values are 0, 1, 2 ... in their order.
template <typename P, typename E>
  requires std::is_enum_v<E>
Parameter<P> choice(std::string name, E P::* member, std::vector<std::string> choices, std::string doc) {
  const double last = static_cast<double>(choices.size()) - 1.0;
  return parameterFor(
      {std::move(name), ParameterSpec::Type::kChoice, 0.0, 0.0, last, std::move(choices), "", std::move(doc)},
      member);
}

/// Parses `text` as a value of `spec`. Errors: kUsage naming the parameter and the allowed range or choices.
Result<double> parseParameter(const ParameterSpec& spec, const std::string& text);

/// The index of the parameter `name`. Errors: kUsage naming `owner`, with a suggestion among the parameters
/// and `others`.
Result<std::size_t> findParameter(const std::vector<ParameterSpec>& specs, const std::string& name,
                                  const std::string& owner, const std::vector<std::string>& others = {});

/// The documentation of all `parameters`.
template <typename P>
std::vector<ParameterSpec> specsOf(const std::vector<Parameter<P>>& parameters) {
  std::vector<ParameterSpec> specs;
  specs.reserve(parameters.size());
  for (const auto& parameter : parameters) specs.push_back(parameter.spec);
  return specs;
}

/// Applies `settings` to `values`. Errors: kUsage, as `findParameter` and `parseParameter`.
template <typename P>
Result<void> applySettings(const std::vector<Parameter<P>>& parameters, const std::vector<Setting>& settings,
                           const std::string& owner, P& values, const std::vector<std::string>& others = {}) {
  const std::vector<ParameterSpec> specs = specsOf(parameters);
  for (const Setting& setting : settings) {
    const auto index = findParameter(specs, setting.name, owner, others);
    if (!index) return tl::unexpected<Error>(index.error());
    const auto value = parseParameter(specs[*index], setting.value);
    if (!value) return tl::unexpected<Error>(value.error());
    parameters[*index].set(values, *value);
  }
  return {};
}

}  // namespace fulbito
