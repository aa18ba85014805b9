#pragma once

#include <string>
#include <vector>

#include "fulbito/strategy.hpp"
#include "tournament/tune/spsa.hpp"

namespace fulbito {

/// A team's specification split into parts, so that parameters can be set in it.
struct TunedTeam {
  std::string stem;               ///< the specification without settings
  bool program = false;           ///< the team is a command line whose last word holds the settings
  std::vector<Setting> settings;  ///< settings in the specification, tuned or not

  /// Splits a specification of any kind of team. Errors: as `parseTeamCommand`; kUsage for settings in
  /// quotes.
  static Result<TunedTeam> of(const TeamChoice& team);

  /// The specification with the parameters at a point. Settings it already has change in place, others are
  /// appended.
  std::string at(const std::vector<TunedParameter>& parameters, const TunePoint& point) const;
};

/// The value of a parameter in a match, as text. It is rounded to a hundred-thousandth of the range or finer;
/// a whole number to the nearest one. It never leaves the limits.
std::string valueText(const TunedParameter& parameter, double share);

/// The parameters of a tuning, selected by the specification and the flags.
struct ParameterChoice {
  std::vector<TunedParameter> parameters;
  /// Flags and choices: they cannot be tuned, because their values have no order.
  std::vector<std::string> skipped;
};

/// Selects parameters. An empty list means all real and whole numbers that the team declares; they start from
/// the values in the specification or the defaults. A word is `name` or
/// `name=start:low:high[:c_end[:r_end]]`, with `c_end` in the parameter's unit. For a declared parameter,
/// start, low and high may be empty. The perturbation of a whole number is at least 1/2, so that both
/// versions differ. Errors: kUsage naming the parameter.
/// @param perturbation  c_end for parameters that do not give it, as share of the range
/// @param step  r_end for parameters that do not give it
Result<ParameterChoice> parametersOf(const TeamChoice& team, const TunedTeam& parts,
                                     const std::vector<std::string>& words, double perturbation, double step);

}  // namespace fulbito
