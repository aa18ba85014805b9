#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fulbito/detail/parameters.hpp"
#include "fulbito/strategy.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/skills/ball_drive.hpp"
#include "strategies/skills/goalkeeping.hpp"
#include "strategies/skills/unsticking.hpp"
#include "strategies/skills/wall_play.hpp"

namespace fulbito::sparring {

/// What all sparring teams share: robot 0 keeps the goal line, the field players have an order from the one
/// that is first at the ball, and all stay legal and yield to each other. A school says only what its field
/// players do.
class School : public Strategy {
 public:
  struct Params {
    bool spins = false;  ///< spins at any ball that is stuck, not at walls only
  };
  /// What a team's catalogue entry says of them.
  static std::vector<Parameter<Params>> parameters();

  School(Params params, NavigatorChoice navigator) : params_{params}, navigators_{std::move(navigator)} {}

  void begin(const MatchInfo& info) override;
  std::span<const NavigatorChoice> navigators() const override { return navigators_; }
  TeamCommand decide(const Observation& seen) final;
  std::optional<TeamProposal> place(const PlacementRequest& request) override;

 protected:
  /// The name of the roles in drawings, by rank: keeper, first at the ball, second ...
  virtual const char* roleName(std::size_t rank) const;
  /// A new play or match begins: forget what was remembered.
  virtual void restart() {}
  /// The command of the field player `i`, the `rank`-th nearest to the ball (1: first).
  virtual RobotCommand play(const Observation& now, std::size_t i, std::size_t rank) = 0;
  /// The keeper's command.
  virtual RobotCommand keep(const Observation& now, std::size_t i);
  /// Cost [s] of robot `i` as the first at the ball.
  virtual double cost(const Observation& now, std::size_t i) const;

  /// @{ What field players are made of.
  /// Where robot `i` meets the ball.
  Vec2 meeting(const Observation& now, std::size_t i, Vec2 aim) const;
  /// How a robot attacks the ball.
  struct Style {
    std::optional<Vec2> toward;  ///< [m] target of the ball; empty: `wanted`
    double bend = 1.0;           ///< as in `DriveGoal`
    double room = 0.03;          ///< [m] as in `DriveGoal`
    bool straight = true;     ///< a ball that an opponent reaches first is hit straight, if that is upfield
    SpinSettings spins = {};  ///< when it spins
  };
  /// Drives through the ball. A ball in the own area is left to the keeper.
  RobotCommand attack(const Observation& now, std::size_t i, const Style& style);
  RobotCommand attack(const Observation& now, std::size_t i) { return attack(now, i, Style()); }
  /// Drives through the ball along `direction`.
  RobotCommand drive(const Observation& now, std::size_t i, DriveGoal goal);
  /// Drives with all that the motors have.
  RobotCommand twist(const Observation& now, std::size_t i, Twist wanted) const;
  /// Stands at a place, turned toward `heading` if given, outside both areas.
  RobotCommand stand(Vec2 place, std::optional<double> heading = {}) const;
  /// Where the ball should go from `ball`, a unit vector: at the goal, up a side from the own third, along a
  /// wall at which it lies.
  Vec2 wanted(const Observation& now, Vec2 ball) const;
  /// Spins if the ball is stuck at robot `i` at a wall or between two robots.
  std::optional<RobotCommand> spin(const Observation& now, std::size_t i, Vec2 direction,
                                   const SpinSettings& settings = {});
  /// Distance [m] from ball to robot, centre to centre, from which a turning robot can touch the ball.
  double spinReach() const;
  /// Least time [s] in which an opponent reaches `place`.
  double theirTime(const Observation& now, Vec2 place) const;
  /// @}

  const MatchInfo& info() const { return info_; }
  const FieldGeometry& field() const { return info_.field; }
  const Foresight& foresight() const { return foresight_; }
  /// The field players in order; the first is `order()[0]`.
  std::span<const std::size_t> order() const { return {order_.data(), players_}; }

 private:
  /// What one robot remembers between ticks.
  struct Memory {
    BallDrive drive;
    SpinKick spin;
    Unsticking unsticking;
  };

  SpinSettings spinsAnywhere() const;
  void rank(const Observation& now);
  Vec2 pastOpponent(const Observation& now, Vec2 ball, Vec2 straight) const;
  std::optional<RobotCommand> legal(const Observation& now, std::size_t i, bool first) const;
  std::optional<RobotCommand> yielding(const Observation& now, std::size_t i, std::size_t rank) const;

  Params params_;
  std::vector<NavigatorChoice> navigators_;
  MatchInfo info_;
  Foresight foresight_;
  LineKeeper keeper_;
  std::array<Memory, kMaxTeamSize> memory_;
  std::array<std::size_t, kMaxTeamSize> order_{};
  std::size_t players_ = 0;
};

}  // namespace fulbito::sparring
