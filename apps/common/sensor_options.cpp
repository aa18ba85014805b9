#include "apps/common/sensor_options.hpp"

#include <CLI/CLI.hpp>

namespace fulbito::app {

void addSensors(CLI::App& command, SensorModel& sensors) {
  command.add_option("--latency", sensors.latency_ticks, "age of observations [control ticks], 0 ... 60")
      ->capture_default_str();
  command
      .add_option("--noise", sensors.position_noise,
                  "noise of observed positions: standard deviation [m], 0 ... 0.1")
      ->capture_default_str();
  command.add_option("--dropout", sensors.dropout, "chance that a body is not seen in a tick, 0 ... 0.99")
      ->capture_default_str();
}

}  // namespace fulbito::app
