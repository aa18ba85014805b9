#include "apps/common/match_settings.hpp"

#include <charconv>
#include <limits>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/option_values.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kUnlimited = "unlimited";

Result<void> addStart(const std::string& file, MatchConfig& config) {
  if (file.empty()) return {};
  auto start = loadStartState(file, config);
  if (!start) return tl::unexpected<Error>(start.error());
  setStart(config, *start);
  return {};
}

Result<void> shorten(const MatchSettings& settings, Rules& rules) {
  if (!settings.half_seconds) return {};
  rules.half_seconds = *settings.half_seconds;
  const auto checked = validate(rules);
  if (!checked) return fail(ErrorCode::kUsage, "--half-seconds: " + checked.error().message);
  return {};
}

/// Applies the values of a flag: one value for both teams, or one for blue and one for yellow.
template <typename T>
Result<void> readPerTeam(const char* flag, const std::vector<T>& values, PerTeam<VisionModel>& vision,
                         T VisionModel::* part) {
  if (values.size() > 2) return fail(ErrorCode::kUsage, fmt::format("{}: takes one or two values", flag));
  for (const TeamId team : kTeams) {
    const bool own = values.size() == 2 && team == TeamId::kYellow;
    vision[indexOf(team)].*part = own ? values.back() : values.front();
  }
  return {};
}

Result<PerTeam<VisionModel>> visionOf(const MatchSettings& settings, const RobotModel& robot) {
  PerTeam<VisionModel> vision;
  for (const auto& done :
       {readPerTeam("--latency", settings.sensors.latency_ticks, vision, &VisionModel::latency_ticks),
        readPerTeam("--noise", settings.sensors.position_noise, vision, &VisionModel::position_noise),
        readPerTeam("--dropout", settings.sensors.dropout, vision, &VisionModel::dropout)}) {
    if (!done) return tl::unexpected<Error>(done.error());
  }
  // As in trials, heading noise follows from position noise.
  for (VisionModel& seat : vision) seat.heading_noise = headingNoise(seat.position_noise, robot.length);
  return vision;
}

/// The time limit of both teams: that of the rules, with the time per decision replaced by `text`.
Result<DecisionTime> limitOf(const std::string& text, const Rules& rules) {
  DecisionTime limit = rules.decision_time;
  if (text == kUnlimited) {
    limit.decision = std::numeric_limits<double>::infinity();
    return limit;
  }
  double milliseconds = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), milliseconds);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size()) {
    return fail(ErrorCode::kUsage,
                fmt::format("--time: '{}' is neither a number of ms nor '{}'", text, kUnlimited));
  }
  limit.decision = milliseconds * 1e-3;
  return limit;
}

}  // namespace

Result<MatchConfig> configOf(const MatchSettings& settings) {
  const TeamCatalogue catalogue = catalogueOf(settings.outside);
  auto blue = catalogue.parse(settings.blue), yellow = catalogue.parse(settings.yellow);
  if (!blue) return tl::unexpected<Error>(blue.error());
  if (!yellow) return tl::unexpected<Error>(yellow.error());
  auto config = configWithoutTeams(settings);
  if (config) config->teams = {std::move(*blue), std::move(*yellow)};
  return config;
}

Result<MatchConfig> configWithoutTeams(const MatchSettings& settings) {
  auto rules = loadRules(settings.rules);
  if (!rules) return tl::unexpected<Error>(rules.error());
  auto field = loadField(rules->field);
  if (!field) return tl::unexpected<Error>(field.error());
  auto robot = loadRobot(settings.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  auto physics = loadPhysics(settings.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  MatchConfig config;
  config.rules = std::move(*rules);
  if (auto shortened = shorten(settings, config.rules); !shortened) {
    return tl::unexpected<Error>(shortened.error());
  }
  config.field = std::move(*field);
  config.robot = std::move(*robot);
  config.physics = std::move(*physics);
  auto vision = visionOf(settings, config.robot.robot);
  if (!vision) return tl::unexpected<Error>(vision.error());
  config.vision = *vision;
  if (!settings.time.empty()) {
    auto limit = limitOf(settings.time, config.rules);
    if (!limit) return tl::unexpected<Error>(limit.error());
    config.decision_time = *limit;
  }
  config.seed = settings.seed;
  if (auto started = addStart(settings.start, config); !started)
    return tl::unexpected<Error>(started.error());
  return config;
}

void addMatchSettings(CLI::App& command, MatchSettings& settings, const char* seats) {
  command.add_option("--rules", settings.rules, "rules profile or TOML file")->capture_default_str();
  command.add_option("--physics", settings.physics, "physics profile or TOML file")->capture_default_str();
  command.add_option("--robot", settings.robot, "robot preset or TOML file, for both teams")
      ->capture_default_str();
  addSeed(command, settings.seed, "coin tosses, placement error, sensor noise, teams");
  command.add_option("--half-seconds", settings.half_seconds,
                     "length of a half [s] (default: from the rules)");
  command.add_option("--start", settings.start, "start state (TOML file) instead of the first kick-off")
      ->type_name("FILE");
  addSensors(command, settings.sensors, seats);
  command
      .add_option("--time", settings.time,
                  "wall time per decision, or 'unlimited' (default: the rules limit programs only)")
      ->type_name("MS");
  addTeamFlags(command, settings.outside);
}

}  // namespace fulbito::app
