#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "fulbito/detail/vec2.hpp"
#include "referee/geometry/areas.hpp"

/// What the referee may call: one function per call, each in a file of its own (`detectGoal` in goal.cpp),
/// and what it remembers between ticks.
namespace fulbito {

struct DetectorInput;
struct Finding;

/// A tick in the distant past: never.
inline constexpr Tick kLongAgo = -1000000000;

/// One tick per robot of a view, initially `kLongAgo`.
struct RobotTicks {
  constexpr RobotTicks() { at.fill(kLongAgo); }
  constexpr Tick& operator[](std::size_t i) { return at[i]; }
  constexpr Tick operator[](std::size_t i) const { return at[i]; }
  std::array<Tick, kMostRobots> at{};
};

/// An interval that tolerates short gaps: start, last tick and accumulated amount.
struct Spell {
  Tick since = kLongAgo;
  Tick last = kLongAgo;
  double sum = 0.0;

  /// Extends the spell to this tick, or starts a new one after a gap of more than `release` ticks.
  void add(Tick tick, Tick release, double amount = 0.0) {
    if (tick - last > release + 1) *this = {tick, kLongAgo, 0.0};
    last = tick;
    sum += amount;
  }
  /// Its length in ticks if it includes `tick`, else 0.
  Tick ticks(Tick tick) const { return last == tick ? tick - since + 1 : 0; }
};

/// The ticks at which each robot last touched the ball or another robot.
struct TouchMemory {
  RobotTicks ball;      ///< the robot touched the ball
  RobotTicks opponent;  ///< the robot touched a robot of the other team
  RobotTicks keeper;    ///< the robot touched the other team's keeper
  /// opponents pressed the robot toward the goal of its half; sum: impulse [kg m/s]
  std::array<Spell, kMostRobots> pushed;
};

/// Memory of the stuck-ball detector.
struct StuckMemory {
  bool counting = false;
  Tick since = 0;        ///< start of the count, moved later by the ticks for which it paused
  Vec2 anchor;           ///< [m] position of the ball at that time
  Tick fast_since = -1;  ///< the ball is too fast since this tick; -1: it is not
  Tick in_area = 0;      ///< ticks of the count with the ball in a goal area
};

/// When robots entered the areas, and the keepers.
struct PresenceMemory {
  RobotTicks goal_area;                        ///< tick of entry; kLongAgo while outside
  RobotTicks big_area;                         ///< the same
  RobotTicks excused_until;                    ///< last tick of the excuse for being pushed in
  PerTeam<std::optional<std::size_t>> keeper;  ///< index in the view
};

/// More robots in an area than the rules allow.
struct AreaFoul {
  Side side = Side::kLeft;
  bool big = false;
  std::size_t robot = 0;  ///< the robot in excess
  int count = 0;          ///< robots inside
  int allowed = 0;
};

/// An area foul with a pending decision.
struct PendingFoul {
  AreaFoul foul;
  Tick since = 0;
  Tick ticks = 0;          ///< number of ticks with the foul
  bool with_ball = false;  ///< the ball has been in the area since then
};

/// Memory of the detectors of laws 8.2 and 8.3.
struct AreaFoulMemory {
  std::optional<PendingFoul> attack;
  std::optional<PendingFoul> defence;
};

/// Memory of the keeper detectors.
struct KeeperMemory {
  std::array<Spell, kMostRobots> charges;  ///< by the charging robot; sum: impulse [kg m/s]
  PerTeam<Spell> control;                  ///< undisputed control of the ball
};

/// Memory of the detectors of pushing and holding.
struct FoulMemory {
  std::array<Spell, kMostRobots> pushes;  ///< by the pushing robot; sum: impulse [kg m/s]
  std::array<Spell, kMostRobots> pinned;  ///< by the robot that pins the ball to a wall
};

/// All memory of the detectors between ticks: a plain value, empty at every restart.
struct DetectorMemory {
  AreaReport areas{};  ///< areas of the previous tick
  TouchMemory touches;
  PresenceMemory presence;
  AreaFoulMemory area_fouls;
  KeeperMemory keeper;
  FoulMemory fouls;
  StuckMemory stuck;
};

/// Law 7.1: the whole ball (or its centre) is past the goal line.
std::optional<Finding> detectGoal(const DetectorInput& input, const TouchMemory& touches);

/// Laws 13 and 14: the ball is stuck. In a goal area: a goal kick if robots of both teams dispute it, else
/// what `StuckRules::undisputed` says; elsewhere a free ball. `keepers` is the memory after this tick: the
/// count pauses while a keeper has undisputed control.
std::optional<Finding> detectStuckBall(const DetectorInput& input, const KeeperMemory& keepers,
                                       StuckMemory& memory);

/// Law 8.2: more attackers than allowed in the opponents' goal area (or big area). If the rules say so, it is
/// a foul only if a robot beyond the first takes part: it touched the ball or the keeper within
/// `part_seconds`.
std::optional<AreaFoul> detectAttackers(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

/// Law 8.3: more defenders than allowed in their own goal area (or big area) with the ball inside. If the
/// rules say so, it is a foul only if a robot beyond the first takes part: it touched the ball or an opponent
/// within `part_seconds`.
std::optional<AreaFoul> detectDefenders(const DetectorInput& input, const TouchMemory& touches,
                                        const PresenceMemory& presence);

/// Laws 8.1 and 13: an opponent charges or blocks the keeper in its goal area. The keeper is in the area, and
/// the opponent presses on it at a point in the area. (With the ball between them, the two do not touch.) The
/// contact lasts `charge_seconds` with `charge_impulse` in all. The opponent does not dispute the ball: it
/// has not touched it for `part_seconds`.
std::optional<Finding> detectKeeperCharged(const DetectorInput& input, const TouchMemory& touches,
                                           const PresenceMemory& presence, KeeperMemory& memory);

/// Law 8.1: the keeper keeps the ball. For `hold_seconds`, keeper and ball are in its goal area, and the ball
/// is at most `control_gap` from its body. Breaks up to `release_seconds` do not end the count. An opponent
/// within `dispute_lengths` of the ball challenges: the count begins anew.
std::optional<Finding> detectKeeperHolding(const DetectorInput& input, const PresenceMemory& presence,
                                           KeeperMemory& memory);

/// A robot other than a keeper in its area holds the ball: it pins it to a wall. The robot presses the ball,
/// the ball presses a wall, both hardly move and no opponent disputes it, for longer than `pinned_seconds`.
/// The call is a free kick, or a penalty in the robot's own goal area (law 8.1). Law 2.2.3 forbids hiding
/// more than 30 % of the ball: that takes a hollow body, and all bodies here are full rectangles.
std::optional<Finding> detectHolding(const DetectorInput& input, const PresenceMemory& presence,
                                     FoulMemory& memory);

/// Law 8.1: a robot pushes an opponent that is away from the ball. The two press on each other for
/// `push_seconds` with `push_impulse` in all. The pushed robot moves away from the pusher at `push_speed` or
/// more. Both centres are farther than `push_distance` from the ball, and neither robot touched it for
/// `part_seconds`.
std::optional<Finding> detectPush(const DetectorInput& input, const TouchMemory& touches, FoulMemory& memory);

}  // namespace fulbito
