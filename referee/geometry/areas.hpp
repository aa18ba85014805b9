#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/core/models/goal_area.hpp"
#include "fulbito/detail/detector_rules.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"
#include "referee/state/match_view.hpp"

namespace fulbito {

/// Largest number of robots on the field.
inline constexpr std::size_t kMostRobots = 2 * static_cast<std::size_t>(kMaxTeamSize);

/// A set of robots: bit i is robot i of a MatchView.
using RobotSet = std::uint32_t;

/// A body in the frame of a goal.
struct AreaBody {
  Vec2 centre;
  Vec2 x_axis;  ///< unit vector of its heading
  double half_length = 0.0;
  double half_width = 0.0;
};

/// The robot's body in the frame of the goal at `side`.
AreaBody intoGoalFrame(const FieldGeometry& field, Side side, const RobotModel& robot, const Pose2& pose);

/// Whether the body and the area share more than a line. Exact, including the arc.
bool overlaps(const AreaShape& area, const AreaBody& body);
/// The share of the body inside the area, 0 ... 1. Exact, including the arc.
double shareInside(const AreaShape& area, const AreaBody& body);
/// Whether the body counts as inside by `part`.
bool counts(const AreaShape& area, const AreaBody& body, BodyPart part);

/// Ball and robots in the areas at one goal, counted by the rules.
struct GoalAreaReport {
  bool ball = false;           ///< its centre is in the goal area
  bool ball_in_big = false;    ///< its centre is in the big area
  RobotSet attackers = 0;      ///< robots of the team that attacks this goal, in the goal area
  RobotSet defenders = 0;      ///< robots of the team that defends it, in the goal area
  RobotSet big_attackers = 0;  ///< the same in the big area
  RobotSet big_defenders = 0;
};

/// The areas' content in one tick, by Side.
using AreaReport = std::array<GoalAreaReport, 2>;

/// The shapes of a match's areas: computed once, used every tick.
struct AreaSetup {
  AreaShape goal_area, goal_area_grown;
  AreaShape big_area, big_area_grown;
};
AreaSetup areaSetup(const FieldGeometry& field, const AreaRules& rules);

/// Counts one tick. `before` is the previous tick's report, for hysteresis; empty at a restart.
AreaReport reportAreas(const MatchView& view, const FieldGeometry& field, const RobotModel& robot,
                       const AreaRules& rules, Side blue_side, const AreaReport& before);

}  // namespace fulbito
