#pragma once

#include <string>

namespace fulbito {

/// The last line of reports: simulated time [s] and, where `wall` [s] is positive, the simulation speed.
std::string speedLine(double simulated, double wall);

}  // namespace fulbito
