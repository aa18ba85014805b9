#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "engine/core/base/vec2.hpp"
#include "referee/geometry/areas.hpp"

namespace fulbito {

/// A tick so long ago that nothing recent is meant.
inline constexpr Tick kLongAgo = -1000000000;

/// One value for each robot of a view, at first `kLongAgo`.
struct RobotTicks {
  constexpr RobotTicks() { at.fill(kLongAgo); }
  constexpr Tick& operator[](std::size_t i) { return at[i]; }
  constexpr Tick operator[](std::size_t i) const { return at[i]; }
  std::array<Tick, kMostRobots> at{};
};

/// Something that lasts, with short breaks: when it began, when it was seen last, what it came to.
struct Run {
  Tick since = kLongAgo;
  Tick last = kLongAgo;
  double sum = 0.0;

  /// Seen in this tick; it begins anew after a break of more than `release` ticks.
  void add(Tick tick, Tick release, double amount = 0.0) {
    if (tick - last > release + 1) *this = {tick, kLongAgo, 0.0};
    last = tick;
    sum += amount;
  }
  /// For how many ticks it has lasted when it was seen in `tick`, else 0.
  Tick ticks(Tick tick) const { return last == tick ? tick - since + 1 : 0; }
};

/// Who touched what when.
struct TouchMemory {
  RobotTicks ball;                      ///< the robot touched the ball
  RobotTicks opponent;                  ///< the robot touched a robot of the other team
  RobotTicks keeper;                    ///< the robot touched the other team's keeper
  std::array<Run, kMostRobots> pushed;  ///< opponents pressed it toward the goal of its half; sum in kg m/s
};

/// Of the stuck ball.
struct StuckMemory {
  bool counting = false;
  Tick since = 0;        ///< the count began; later by the ticks for which it stood
  Vec2 anchor;           ///< [m] where the ball was then
  Tick fast_since = -1;  ///< the ball has been too fast since; -1: it is not
  Tick in_area = 0;      ///< ticks of the count in which the ball was in a goal area
};

/// Since when robots are in the areas, and who keeps the goal.
struct PresenceMemory {
  RobotTicks goal_area;                        ///< it came in; kLongAgo while outside
  RobotTicks big_area;                         ///< the same
  RobotTicks excused_until;                    ///< it was pushed in while disputing
  PerTeam<std::optional<std::size_t>> keeper;  ///< index in the view
};

/// More robots in an area than the rules allow.
struct AreaFoul {
  Side side = Side::kLeft;
  bool big = false;
  std::size_t robot = 0;  ///< the one that is one too many
  int count = 0;          ///< robots inside
  int allowed = 0;
};

/// An area foul that waits for its decision.
struct PendingFoul {
  AreaFoul foul;
  Tick since = 0;
  Tick ticks = 0;          ///< for how many it was seen
  bool with_ball = false;  ///< the ball has been in the area meanwhile
};

/// Of laws 8.2 and 8.3.
struct AreaFoulMemory {
  std::optional<PendingFoul> attack;
  std::optional<PendingFoul> defence;
};

/// Of the keepers.
struct KeeperMemory {
  std::array<Run, kMostRobots> charges;  ///< by the charging robot; sum in kg m/s
  PerTeam<Run> control;                  ///< undisputed, of the ball
};

/// Of pushing and holding.
struct FoulMemory {
  std::array<Run, kMostRobots> pushes;  ///< by the pushing robot; sum in kg m/s
  std::array<Run, kMostRobots> pinned;  ///< by the robot that presses the ball against a wall
};

/// What the detectors know between ticks: a plain value, empty at every restart.
struct DetectorMemory {
  AreaReport areas{};  ///< of the tick before
  TouchMemory touches;
  PresenceMemory presence;
  AreaFoulMemory area_fouls;
  KeeperMemory keeper;
  FoulMemory fouls;
  StuckMemory stuck;
};

}  // namespace fulbito
