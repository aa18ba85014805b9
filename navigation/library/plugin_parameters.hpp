#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fulbito/navigation.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// Converts the parameters of a library. Errors: kBadInput naming `where` and the parameter.
Result<std::vector<ParameterSpec>> pluginParameters(const fulbito_parameter* parameters, std::uint32_t count,
                                                    const std::string& where);

/// The values of all parameters in order, from `settings` or the defaults. Errors: kUsage naming `owner` and
/// the parameter, with a suggestion or the range.
Result<std::vector<double>> pluginValues(const std::vector<ParameterSpec>& specs,
                                         const std::vector<Setting>& settings, const std::string& owner);

}  // namespace fulbito
