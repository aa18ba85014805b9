#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/unsticking.hpp"
#include "strategies/skills/wall_play.hpp"

namespace fulbito {

/// The textbook team with fixed roles by robot number. Keeper and attacker are in files of their own.
class Classic final : public Strategy {
 public:
  struct Params {
    double keeper_depth = 0.10;  ///< [m] of the keeper's line in front of the goal line
    double support = 0.30;       ///< [m] of the supporter behind the ball
    double strike_speed = 1.2;   ///< [m/s]
    bool exchange = false;       ///< whether another robot may take over the attacker's role
    bool spin = true;            ///< whether robots spin to kick a ball at a wall
  };

  Classic(Params params, NavigatorChoice navigator) : params_(params), navigators_{std::move(navigator)} {}

  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) override;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;
  std::optional<ExerciseReply> exercise(const Observation& seen, const Exercise& task) override;

 private:
  enum class Role : std::uint8_t { kKeeper, kAttacker, kSupporter, kDefender, kWinger };

  /// What one robot remembers between ticks.
  struct Memory {
    bool round = false;
    bool lined_up = false;
    SpinKick spin;
    Unsticking unsticking;
  };

  void chooseAttacker(const Observation& now);
  RobotCommand keeper(const Observation& now, std::size_t i);
  RobotCommand attacker(const Observation& now, std::size_t i);
  RobotCommand supporter(Role role) const;
  std::optional<RobotCommand> keptOutOfAreas(const Observation& now, std::size_t i, Role role) const;
  bool mayClear(const Observation& now, std::size_t i) const;
  RobotCommand clearing(const Observation& now, std::size_t i);
  std::optional<RobotCommand> spinAtBall(const Observation& now, std::size_t i, bool contested);
  bool isHeldByKeeper(const Observation& now) const;
  static RobotCommand spinning(double sense);
  bool isContested(const Observation& now, double mine) const;
  Vec2 aim(const Observation& now, Vec2 ball) const;
  Vec2 wantedDirection(const Observation& now, Vec2 ball) const;
  Role roleOf(std::size_t robot) const;
  void draw(const Observation& now, std::vector<DebugDrawing>& drawings) const;

  Params params_;
  std::vector<NavigatorChoice> navigators_;
  MatchInfo info_;
  Foresight foresight_;
  std::array<Memory, kMaxTeamSize> memory_;
  std::size_t attacker_ = 1;
  double since_exchange_ = 0.0;
};

}  // namespace fulbito
