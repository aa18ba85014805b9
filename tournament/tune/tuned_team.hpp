#pragma once

#include <string>
#include <vector>

#include "fulbito/strategy.hpp"
#include "tournament/tune/spsa.hpp"

namespace fulbito {

/// A specification taken apart, so that parameters can be set in it.
struct TunedTeam {
  std::string stem;               ///< the specification without settings
  bool program = false;           ///< a command line, whose settings are its last word
  std::vector<Setting> settings;  ///< those of the specification, tuned or not

  /// Takes a specification of any kind of team apart. Errors: as `parseTeamCommand`; kUsage for settings in
  /// quotes.
  static Result<TunedTeam> of(const TeamChoice& team);

  /// The specification with the parameters at a point: settings that are there change in their place, others
  /// follow.
  std::string at(const std::vector<TunedParameter>& parameters, const TunePoint& point) const;
};

/// A value as it plays, as text: rounded to a hundred-thousandth of the range or finer, a whole number to the
/// next one. It never leaves the limits.
std::string valueText(const TunedParameter& parameter, double share);

/// What the specification and the flags say about the parameters of a tuning.
struct ParameterChoice {
  std::vector<TunedParameter> parameters;
  std::vector<std::string> skipped;  ///< flags and choices, which have no direction
};

/// Selects parameters. An empty list means all numbers and whole numbers that the team declares, from the
/// values of the specification or their defaults. A word is `name` or
/// `name=start:low:high[:c_end[:r_end]]`, with `c_end` in the parameter's unit; start, low and high may be
/// empty for a declared parameter. The perturbation of a whole number is at least 1/2, so that both versions
/// differ. Errors: kUsage naming the parameter.
/// @param perturbation  c_end of those without one, in shares of the range
/// @param step  r_end of those without one
Result<ParameterChoice> parametersOf(const TeamChoice& team, const TunedTeam& parts,
                                     const std::vector<std::string>& words, double perturbation, double step);

}  // namespace fulbito
