#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "fulbito/detail/math.hpp"
#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito::test {

using Decide = std::function<TeamCommand(const Observation&)>;
using Place = std::function<std::optional<TeamProposal>(const PlacementRequest&)>;

/// A team that does what a test wants.
class TestTeam final : public Strategy {
 public:
  TestTeam(Decide decide, Place place, std::vector<NavigatorChoice> navigators)
      : decide_(std::move(decide)), place_(std::move(place)), navigators_(std::move(navigators)) {}
  void begin(const MatchInfo&) override {}
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& observation) override { return decide_(observation); }
  std::optional<TeamProposal> place(const PlacementRequest& request) override {
    return place_ ? place_(request) : std::nullopt;
  }

 private:
  Decide decide_;
  Place place_;
  std::vector<NavigatorChoice> navigators_;
};

/// A test's team for both seats.
class TestEntry {
 public:
  explicit TestEntry(Decide decide, Place place = {}, std::vector<NavigatorChoice> navigators = {})
      : choice_(
            TeamChoice::own("test", [=] { return std::make_unique<TestTeam>(decide, place, navigators); })) {}
  const TeamChoice& choice() const { return choice_; }

 private:
  TeamChoice choice_;
};

/// A short 3v3 match of two teams of the registry.
inline MatchConfig shortMatch(const std::string& blue = "chaser", const std::string& yellow = "chaser",
                              double half_seconds = 5.0) {
  MatchConfig config;
  config.teams = {*parseTeam(blue), *parseTeam(yellow)};
  config.robot = *loadRobot("vsss");
  config.physics = *loadPhysics("standard");
  config.field = *loadField("vsss-3v3");
  config.rules.half_seconds = half_seconds;
  return config;
}

/// Plays the whole match and gives its hash.
inline std::uint64_t hashOf(const MatchConfig& config) {
  auto match = Match::create(config);
  if (!match) return 0;
  while (match->step()) {
  }
  return match->hash();
}

/// Every robot with the same wheel speeds.
inline TeamCommand allWheels(WheelSpeeds wheels) {
  TeamCommand command;
  command.robots.fill(RobotCommand::byWheels(wheels));
  return command;
}

/// Stands in two columns, blue left; nothing is near the ball at the centre.
inline Placement twoColumns(int team_size = 3) {
  Placement placement;
  for (const TeamId team : kTeams) {
    for (int i = 0; i < team_size; ++i) {
      const double sign = team == TeamId::kBlue ? -1.0 : 1.0;
      placement.robots[indexOf(team)][static_cast<std::size_t>(i)] =
          Pose2{{sign * 0.4, 0.2 * (i - 1)}, team == TeamId::kBlue ? 0.0 : -math::kPi};
    }
  }
  return placement;
}

}  // namespace fulbito::test
