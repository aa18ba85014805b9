#pragma once

#include <vector>

#include "fulbito/models.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Vision of teams: one value for all, or one for each of two seats.
struct SeatSensors {
  std::vector<int> latency_ticks{0};
  std::vector<double> position_noise{0.0};  ///< [m]
  std::vector<double> dropout{0.0};
};

/// @{ Adds `--latency`, `--noise` and `--dropout`: the quality of the observations of a trial, or of two
/// seats whose names are `seats`.
void addSensors(CLI::App& command, SensorModel& sensors);
void addSensors(CLI::App& command, SeatSensors& sensors, const char* seats);
/// @}

}  // namespace fulbito::app
