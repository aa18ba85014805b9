#pragma once

#include <string>
#include <vector>

#include "fulbito/models.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"

namespace fulbito::testing {

/// A match's setup from an embedded profile, with its field and the league robot. Play begins without delay:
/// tests of the delays set them themselves.
inline RefereeSetup setupOf(const std::string& profile) {
  RefereeSetup setup;
  setup.rules = *loadRules(profile);
  setup.rules.restart.delay = setup.rules.restart.goal_delay = 0.0;
  setup.field = *loadField(setup.rules.field);
  const RobotPreset robot = *loadRobot("vsss");
  setup.robot = robot.robot;
  setup.ball = robot.ball;
  return setup;
}

/// A match without physics: robots stand where they were placed, the ball where the test puts it.
class PaperMatch {
 public:
  explicit PaperMatch(const RefereeSetup& setup) : referee(setup) { begin(referee.open()); }

  /// Places all robots by the rules and tells the referee.
  void begin(const RestartCall& next) {
    call = next;
    ++restarts;
    const Placement placement = place(referee.setup(), referee.state(), call, {}, events);
    ids.clear();
    robots.clear();
    for (const TeamId team : kTeams) {
      for (std::size_t n = 0; n < kMaxTeamSize; ++n) {
        const auto& pose = placement.robots[indexOf(team)][n];
        if (!pose) continue;
        ids.push_back({team, static_cast<std::uint8_t>(n)});
        robots.push_back({*pose, {}, 0.0, {}});
      }
    }
    ball = {placement.ball, {}, {}};
    referee.restarted(call, placement, tick);
  }

  /// One tick; a call begins the next play at once.
  bool step() {
    ++tick;
    const auto next = referee.observe({tick, ids, robots, ball, {}}, events);
    if (next) begin(*next);
    return next.has_value();
  }
  /// Plays until a call, the end, or this many seconds; true after a call or the end.
  bool play(double seconds) {
    const double dt = referee.setup().dt;
    for (int i = 0; i < static_cast<int>(seconds / dt + 0.5); ++i) {
      // A ball that keeps moving is never stuck.
      if (wander) ball.position = {0.25 * ((tick / 60) % 2 == 0 ? 1.0 : -1.0), 0.05};
      if (step() || referee.state().ended) return true;
    }
    return false;
  }
  /// The ball goes into the goal that the team attacks.
  void score(TeamId team) {
    const double side = referee.state().sideOf(team) == Side::kLeft ? 1.0 : -1.0;
    ball.position = {side * (referee.setup().field.length / 2 + 0.05), 0.0};
    step();
  }
  /// Number of events with that clause.
  int count(std::string_view clause) const {
    int n = 0;
    for (const GameEvent& event : events) n += event.clause == clause ? 1 : 0;
    return n;
  }

  MatchReferee referee;
  RestartCall call;
  int restarts = 0;
  Tick tick = 0;
  bool wander = true;
  std::vector<RobotId> ids;
  std::vector<RobotState> robots;
  BallState ball;
  std::vector<GameEvent> events;
};

}  // namespace fulbito::testing
