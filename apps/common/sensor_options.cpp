#include "apps/common/sensor_options.hpp"

#include <string>

#include <CLI/CLI.hpp>

#include "apps/common/option_values.hpp"

namespace fulbito::app {
namespace {

constexpr std::uint64_t kManyTicks = 1'000'000;  // the match itself checks the range of --latency

/// @return the three options
template <typename Sensors>
std::vector<CLI::Option*> addAll(CLI::App& command, Sensors& sensors, const std::string& whose) {
  return {command.add_option("--latency", sensors.latency_ticks,
                             "age of observations in ticks, 0 ... 60" + whose),
          command.add_option("--noise", sensors.position_noise,
                             "standard deviation of observed positions [m], 0 ... 0.1"),
          command.add_option("--dropout", sensors.dropout,
                             "probability per tick that a body is not seen, 0 ... 0.99")};
}

}  // namespace

void addSensors(CLI::App& command, SensorModel& sensors) {
  for (CLI::Option* option : addAll(command, sensors, "")) option->capture_default_str();
}

void addSensors(CLI::App& command, SeatSensors& sensors, const char* seats) {
  const auto options = addAll(command, sensors, std::string(": for all teams, or ") + seats);
  wholeNumber(options[0], 0, kManyTicks);
  number(options[1]);
  number(options[2]);
  for (CLI::Option* option : options) {
    // Only a comma makes a list: a word after a space is a team.
    option->delimiter(',')->allow_extra_args(false)->type_name("N[,N]");
  }
}

}  // namespace fulbito::app
