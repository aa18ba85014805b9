#include "referee/calls/note_presence.hpp"

#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

/// Component [kg m/s] of an impulse on the robot toward the goal of its half.
double towardGoal(const DetectorInput& in, Vec2 robot, Vec2 impulse) {
  const double goal = robot.x < 0.0 ? -in.setup.field.length / 2 : in.setup.field.length / 2;
  return dot(unitOr(Vec2{goal, 0.0} - robot, {}), impulse);
}

/// Notes an `impulse` on robot `i` by robot `j` of the other team.
void noteOpponents(const DetectorInput& in, const PresenceMemory& presence, std::size_t i, std::size_t j,
                   Vec2 impulse, TouchMemory& touches) {
  touches.opponent[i] = in.view.tick;
  if (keeperOf(in, in.view.ids[j].team, presence) == j) touches.keeper[i] = in.view.tick;
  const double push = towardGoal(in, in.view.robots[i].pose.position, impulse);
  if (push > 0.0) {
    touches.pushed[i].add(in.view.tick, ticksOf(in.setup.rules.areas.pushed_seconds, in.setup.dt), push);
  }
}

/// Updates the tick at which each robot entered an area.
void noteEntries(RobotSet inside, Tick tick, std::size_t robots, RobotTicks& entered) {
  for (std::size_t i = 0; i < robots; ++i) {
    if (!holds(inside, i)) {
      entered[i] = kLongAgo;
    } else if (entered[i] == kLongAgo) {
      entered[i] = tick;
    }
  }
}

bool pushedIn(const DetectorInput& in, std::size_t i, const TouchMemory& touches) {
  const AreaRules& rules = in.setup.rules.areas;
  return recent(in, touches.ball[i], rules.part_seconds) &&
         recent(in, touches.pushed[i].last, rules.pushed_seconds) &&
         touches.pushed[i].sum >= rules.pushed_impulse;
}

void excuse(const DetectorInput& in, RobotSet entering, const TouchMemory& touches,
            PresenceMemory& presence) {
  if (entering == 0 || !in.setup.rules.areas.pushed_excused) return;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (!holds(entering, i)) continue;
    // An excuse ends when the robot leaves the area.
    const Tick leave = in.view.tick + ticksOf(in.setup.rules.areas.excuse_seconds, in.setup.dt);
    presence.excused_until[i] = pushedIn(in, i, touches) ? leave : kLongAgo;
  }
}

void noteKeeper(const DetectorInput& in, TeamId team, PresenceMemory& presence) {
  auto& keeper = presence.keeper[indexOf(team)];
  if (!keeper) keeper = keeperOf(in, team, presence);
  const RobotSet inside = at(in.areas, in.state.sideOf(team)).defenders;
  if (inside == 0) return;
  const auto since = [&](std::size_t i) { return presence.goal_area[i]; };
  std::optional<std::size_t> longest;
  if (keeper && holds(inside, *keeper)) longest = keeper;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (holds(inside, i) && (!longest || since(i) < since(*longest))) longest = i;
  }
  if (longest) keeper = longest;
}

}  // namespace

void noteTouches(const DetectorInput& in, const PresenceMemory& presence, TouchMemory& touches) {
  for (const ContactEvent& contact : in.view.contacts) {
    if (!isRobot(contact.a, in.view)) continue;
    const std::size_t a = contact.a.index, b = contact.b.index;
    if (contact.b.kind == BodyKind::kBall) touches.ball[a] = in.view.tick;
    if (!isRobot(contact.b, in.view) || in.view.ids[a].team == in.view.ids[b].team) continue;
    const Vec2 impulse = contact.normal * contact.impulse;
    noteOpponents(in, presence, a, b, -impulse, touches);
    noteOpponents(in, presence, b, a, impulse, touches);
  }
}

void notePresence(const DetectorInput& in, const TouchMemory& touches, PresenceMemory& presence) {
  const GoalAreaReport &left = in.areas[0], &right = in.areas[1];
  const RobotSet inside = left.attackers | left.defenders | right.attackers | right.defenders;
  const RobotSet inside_big =
      left.big_attackers | left.big_defenders | right.big_attackers | right.big_defenders;
  const std::size_t robots = robotsIn(in.view);
  RobotSet entering = 0;
  for (std::size_t i = 0; i < robots; ++i) {
    const bool came = holds(inside, i) && presence.goal_area[i] == kLongAgo;
    const bool came_big = holds(inside_big, i) && presence.big_area[i] == kLongAgo;
    if (came || came_big) entering |= RobotSet{1} << i;
  }
  noteEntries(inside, in.view.tick, robots, presence.goal_area);
  noteEntries(inside_big, in.view.tick, robots, presence.big_area);
  excuse(in, entering, touches, presence);
  for (const TeamId team : kTeams) noteKeeper(in, team, presence);
}

std::optional<std::size_t> keeperOf(const DetectorInput& in, TeamId team, const PresenceMemory& presence) {
  if (presence.keeper[indexOf(team)]) return presence.keeper[indexOf(team)];
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (in.view.ids[i] == RobotId{team, 0}) return i;
  }
  return std::nullopt;
}

bool keepsGoal(const DetectorInput& in, std::size_t i, const PresenceMemory& presence) {
  const TeamId team = in.view.ids[i].team;
  return presence.keeper[indexOf(team)] == i && holds(at(in.areas, in.state.sideOf(team)).defenders, i);
}

}  // namespace fulbito
