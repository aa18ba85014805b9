#include "fulbito/match.hpp"

namespace fulbito {

Result<MatchConfig> MatchConfig::standard(const std::string& blue, const std::string& yellow,
                                          const std::string& rules_name) {
  const auto first = parseTeam(blue), second = parseTeam(yellow);
  if (!first) return tl::unexpected<Error>(first.error());
  if (!second) return tl::unexpected<Error>(second.error());
  const auto rules = loadRules(rules_name);
  if (!rules) return tl::unexpected<Error>(rules.error());
  const auto field = loadField(rules->field);
  if (!field) return tl::unexpected<Error>(field.error());
  const auto robot = loadRobot("vsss");
  if (!robot) return tl::unexpected<Error>(robot.error());
  const auto physics = loadPhysics("standard");
  if (!physics) return tl::unexpected<Error>(physics.error());

  MatchConfig config;
  config.teams = {*first, *second};
  config.rules = *rules;
  config.field = *field;
  config.robot = *robot;
  config.physics = *physics;
  return config;
}

}  // namespace fulbito
