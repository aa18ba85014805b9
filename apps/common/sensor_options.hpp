#pragma once

#include "fulbito/models.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Adds `--latency`, `--noise` and `--dropout`: the quality of a trial's observations.
void addSensors(CLI::App& command, SensorModel& sensors);

}  // namespace fulbito::app
