#include <algorithm>
#include <cmath>

#include "tests/second_referee/laws.hpp"

/// Who is inside which area since when, who keeps the goal (law 2.2.3), and who was pushed in (8.2, 8.3).
namespace fulbito::second {
namespace {

/// In this half; a body that was in the area counts until it has left the widened one.
bool stillIn(const Marking& area, const Play& play, const Player& player, bool was) {
  const AreaRules& rules = play.rules().areas;
  const int end = player.pose.position.x < 0.0 ? -1 : 1;
  const bool defends = play.ownEnd(player.id.team) == end;
  return bodyIn(was ? area.widened(rules.hysteresis) : area, play, player.pose, end,
                defends ? rules.defenders_part : rules.attackers_part);
}

/// Impulse [kg m/s] that opponents gave the robot in this moment toward the goal of its half.
double pushTowardGoal(const Play& play, const Moment& moment, std::size_t robot) {
  const Vec2 place = moment.players[robot].pose.position;
  const Vec2 way = Vec2{(place.x < 0.0 ? -1 : 1) * play.match->field.length / 2, 0.0} - place;
  double sum = 0.0;
  for (const ContactEvent& contact : moment.contacts) {
    if (!isPlayer(moment, contact.a) || !isPlayer(moment, contact.b)) continue;
    if (contact.a.index != robot && contact.b.index != robot) continue;
    if (moment.players[contact.a.index].id.team == moment.players[contact.b.index].id.team) continue;
    const double sign = contact.b.index == robot ? 1.0 : -1.0;
    const double push = sign * contact.impulse * dot(contact.normal, way) / std::hypot(way.x, way.y);
    sum += std::max(0.0, push);
  }
  return sum;
}

/// It disputes the ball, and opponents pushed it, in one go that has ended just now at the earliest.
bool pushedIn(const Play& play, std::size_t robot) {
  const AreaRules& rules = play.rules().areas;
  const Tick longest = play.ticks(rules.pushed_seconds);
  if (!rules.pushed_excused || !touchedBall(play, play.moments.size() - 1, robot, rules.part_seconds))
    return false;
  double sum = 0.0;
  Tick last = play.now().tick + 1;  // of the push that was seen before, going back
  for (std::size_t i = play.moments.size(); i-- > 0;) {
    const Moment& then = play.moments[i];
    if (last - then.tick > longest + 1) break;
    const double push = pushTowardGoal(play, then, robot);
    if (push > 0.0) sum += push, last = then.tick;
  }
  return sum >= rules.pushed_impulse;
}

std::optional<std::size_t> numberZero(const Moment& moment, TeamId team) {
  for (std::size_t i = 0; i < moment.players.size(); ++i) {
    if (moment.players[i].id == RobotId{team, 0}) return i;
  }
  return std::nullopt;
}

/// The robot that has been in its own goal area for longest; of equals who kept it so far, else the first.
/// Nobody inside: who kept it so far.
std::optional<std::size_t> keeperOf(const Play& play, TeamId team, std::optional<std::size_t> so_far) {
  const Moment& now = play.now();
  std::optional<std::size_t> keeper;
  const auto longer = [&](std::size_t i) {
    const Tick since = *now.players[i].in_goal_area, best = *now.players[*keeper].in_goal_area;
    return since < best || (since == best && so_far == i);
  };
  for (std::size_t i = 0; i < now.players.size(); ++i) {
    if (now.players[i].id.team != team || !inGoalArea(now, i, play.ownEnd(team))) continue;
    if (!keeper || longer(i)) keeper = i;
  }
  return keeper ? keeper : so_far;
}

}  // namespace

bool bodyIn(const Marking& area, const Play& play, const Pose2& pose, int end, BodyPart part) {
  const RobotModel& body = play.body();
  const Vec2 centre = atEnd(play.match->field, end, pose.position);
  if (part == BodyPart::kCentre) return isIn(area, centre);
  const double reach = std::hypot(body.length, body.width) / 2;
  if (std::abs(centre.y) > area.half_width + reach) return false;
  if (centre.x > std::max(area.depth, area.arc_u + area.arc_radius) + reach) return false;
  Corners corners = cornersOf(pose, body.length, body.width);
  for (Vec2& corner : corners) corner = atEnd(play.match->field, end, corner);
  return part == BodyPart::kAnyPart ? anyPartIn(area, corners) : shareIn(area, corners) > 0.5;
}

void noteAreas(Play& play) {
  Moment& now = play.moments.back();
  const Moment* before = play.moments.size() > 1 ? &play.moments[play.moments.size() - 2] : nullptr;
  const AreaRules& rules = play.rules().areas;
  const Marking goal = goalArea(play.match->field, rules.arc), big = bigArea(play.match->field);
  const auto ball_in = [&](const Marking& area, bool was) {
    const bool here = before != nullptr && before->ballEnd() == now.ballEnd() && was;
    return isIn(here ? area.widened(rules.hysteresis) : area,
                atEnd(play.match->field, now.ballEnd(), now.ball));
  };
  now.ball_in_goal_area = ball_in(goal, before != nullptr && before->ball_in_goal_area);
  now.ball_in_big_area = ball_in(big, before != nullptr && before->ball_in_big_area);
  for (std::size_t i = 0; i < now.players.size(); ++i) {
    Player& player = now.players[i];
    const Player* was = before != nullptr ? &before->players[i] : nullptr;
    const auto in = [&](const Marking& area, std::optional<Tick> since) -> std::optional<Tick> {
      if (!stillIn(area, play, player, since.has_value())) return std::nullopt;
      return since ? since : now.tick;
    };
    player.in_goal_area = in(goal, was != nullptr ? was->in_goal_area : std::nullopt);
    player.in_big_area = in(big, was != nullptr ? was->in_big_area : std::nullopt);
    player.excused_until = was != nullptr ? was->excused_until : std::nullopt;
    const bool came = player.in_goal_area == now.tick || player.in_big_area == now.tick;
    if (came) player.excused_until.reset();
    if (came && pushedIn(play, i)) player.excused_until = now.tick + play.ticks(rules.excuse_seconds);
  }
  for (const TeamId team : kTeams) {
    const auto so_far = before != nullptr ? before->keeper[indexOf(team)] : numberZero(now, team);
    now.keeper[indexOf(team)] = keeperOf(play, team, so_far);
  }
}

}  // namespace fulbito::second
