#include "match/drills/start.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "engine/core/models/field_places.hpp"
#include "engine/core/system/stop_request.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/match.hpp"
#include "fulbito/world.hpp"
#include "referee/restarts/restart_call.hpp"
#include "strategies/interface/team_frame.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {
namespace {

constexpr double kGap = 0.12;         // [m] gap between a centred keeper's body and a ball beside the post
constexpr double kLongestRoll = 5.0;  // [s] longest time for which a ball rolls into the goal
constexpr int kMaxDraws = 20000;      // draws before a start is given up
// balls rolled before a start is given up; one in a hundred shots off the wall goes in
constexpr int kMaxRolls = 5000;

/// The path of a ball that nobody touches.
struct BallWay {
  bool conceded = false;  ///< it goes into the left goal
  int bounces = 0;        ///< bounces before that
  double length = 0.0;    ///< [m]
};

BallWay rollAlone(const MatchConfig& match, const Placement& placement) {
  WorldConfig alone;
  alone.field = match.field;
  alone.physics = match.physics;
  alone.balls.push_back({match.robot.ball, placement.ball, placement.ball_velocity, placement.ball_velocity});
  BallWay way;
  auto world = World::create(alone);
  if (!world) return way;
  const double in_goal = match.field.length / 2 + match.robot.ball.radius;
  const auto ticks = static_cast<Tick>(kLongestRoll * match.physics.control_rate);
  Vec2 last = placement.ball;
  bool at_wall = false;
  while (!way.conceded && world->state().tick < ticks) {
    world->step({});
    way.bounces += !world->contacts().empty() && !at_wall ? 1 : 0;
    at_wall = !world->contacts().empty();
    const Vec2 now = world->state().balls.front().position;
    way.length += distance(now, last);
    last = now;
    way.conceded = now.x < -in_goal;
    if (now.x > in_goal) break;
  }
  return way;
}

std::vector<Pose2> standing(const Placement& placement) {
  std::vector<Pose2> poses;
  for (const auto& team : placement.robots) {
    for (const auto& pose : team) {
      if (pose) poses.push_back(*pose);
    }
  }
  return poses;
}

double draw(Rng& rng, double low, double high) { return rng.uniform(low, std::max(low, high)); }

Vec2 spread(Rng& rng, Vec2 at, Vec2 by) {
  return at + Vec2{rng.uniform(-1.0, 1.0) * by.x, rng.uniform(-1.0, 1.0) * by.y};
}

/// Draws the parts of one scene, in a fixed order.
class SceneDraw {
 public:
  SceneDraw(const Drill& drill, const MatchConfig& match, Rng& rng, int turn)
      : drill_(drill),
        match_(match),
        field_(match.field),
        robot_(match.robot),
        rng_(rng),
        turn_(static_cast<std::size_t>(turn)) {}

  /// Draws the scene. False when a body would overlap a wall or another body.
  bool draw(const DrillStart& start, DrillScene& scene) {
    scene.placement = {};
    scene.roles = {};
    drawBall(start, scene.placement);
    PerTeam<int> next{};
    for (const DrillRobot& robot : drill_.robots) {
      if (!robot.start.empty() && robot.start != start.name) continue;
      int& count = next[indexOf(robot.team)];
      const auto number = static_cast<std::size_t>(robot.number >= 0 ? robot.number : count);
      count = std::max(count, static_cast<int>(number) + 1);
      if (number >= kMaxTeamSize) return false;
      scene.placement.robots[indexOf(robot.team)][number] = poseOf(robot, scene.placement.ball);
      scene.roles[indexOf(robot.team)][number] = robot.plays;
    }
    drawTask(start, scene);
    return fits(start, scene) && (!start.enters || enters(start, scene.placement));
  }

  /// Number of balls that were rolled to find out whether they go in.
  int rolls() const { return rolls_; }

 private:
  Vec2 taken(const std::vector<Vec2>& places) const { return places[turn_ % places.size()]; }

  /// The part of the distance of a ball of `speed` that the keeper's reach gives.
  double savableDistance(const DrillStart& start, double speed) const {
    const double counts = start.savable_speed > 0.0 ? start.savable_speed : speed;
    return start.savable * leastSavableDistance(drill_, robot_.robot, counts);
  }

  void drawBall(const DrillStart& start, Placement& placement) {
    const double speed = fulbito::draw(rng_, start.speed_min, start.speed_max);
    const Vec2 aim = start.toward.empty() ? Vec2{}
                                          : start.toward.front() +
                                                (start.toward.back() - start.toward.front()) * rng_.uniform();
    if (start.ball.empty() && start.toward.empty()) return;  // the restart's rule places the ball
    if (start.ball.empty()) {
      const double side = aim.x < 0.0 ? 1.0 : -1.0;
      const double distance =
          fulbito::draw(rng_, start.distance_min, start.distance_max) + savableDistance(start, speed);
      const Vec2 way = math::unit(rng_.uniform(-1.0, 1.0) * start.angle) * distance;
      placement.ball = aim + Vec2{side * way.x, way.y};
    } else {
      placement.ball = spread(rng_, taken(start.ball), start.ball_spread);
    }
    if (!start.toward.empty()) {
      placement.ball_velocity = math::unit(math::angleOf(aim - placement.ball)) * speed;
    }
  }

  Pose2 poseOf(const DrillRobot& robot, Vec2 ball) {
    Vec2 at = spread(rng_, taken(robot.at), robot.spread);
    double heading = robot.heading + rng_.uniform(-1.0, 1.0) * robot.heading_spread;
    if (robot.behind_ball) {
      const double line = math::angleOf(Vec2{field_.length / 2, 0.0} - ball);
      const Vec2 along = math::unit(line);
      at = ball + along * at.x + Vec2{-along.y, along.x} * at.y;
      heading += line;
    } else if (robot.from_ball) {
      at += ball;
    }
    if (robot.equal_gap) {
      // In the frame of the goal that the robot is nearer to.
      const Side side = at.x < 0.0 ? Side::kLeft : Side::kRight;
      const double depth = field_.length / 2 - std::abs(at.x);
      at.y += inTeamFrame(side, equalGapPoint(field_, inTeamFrame(side, ball), depth)).y;
    }
    if (robot.face_ball) heading += math::angleOf(ball - at);
    return {at, math::wrapAngle(heading)};
  }

  void drawTask(const DrillStart& start, DrillScene& scene) {
    Exercise& exercise = scene.exercise;
    const auto& own = scene.placement.robots[indexOf(TeamId::kBlue)][0];
    const Pose2 from = own.value_or(Pose2{});
    const double turn = fulbito::draw(rng_, start.turn_min, start.turn_max);
    const double distance = fulbito::draw(rng_, start.target_min, start.target_max);
    exercise.heading = math::wrapAngle(from.heading + turn);
    exercise.speed = start.task_speed;
    exercise.horizon = start.horizon;
    exercise.target = from.position + math::unit(exercise.heading) * distance;
    switch (start.task) {
      case DrillTask::kTurn:
        exercise.kind = Exercise::Kind::kTurn;
        exercise.target = from.position;
        break;
      case DrillTask::kReachBall:
        exercise.kind = Exercise::Kind::kReachBall;
        exercise.target = scene.placement.ball;
        break;
      case DrillTask::kPush:
        exercise.kind = Exercise::Kind::kPush;
        exercise.target = scene.placement.ball + math::unit(exercise.heading) * distance;
        break;
      case DrillTask::kPredictBall:
        exercise.kind = Exercise::Kind::kPredictBall;
        break;
      default:
        exercise.kind = Exercise::Kind::kReachPose;
    }
  }

  bool fits(const DrillStart& start, const DrillScene& scene) const {
    const double ball = robot_.ball.radius;
    if (!insideField(field_, scene.placement.ball, ball + 0.0005)) return false;
    const std::vector<Pose2> robots = standing(scene.placement);
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (!robotFits(robots[i], scene.placement.ball)) return false;
      for (std::size_t j = 0; j < i; ++j) {
        if (distance(robots[i].position, robots[j].position) < 2.0 * robot_.robot.circumradius())
          return false;
      }
    }
    if (start.task == DrillTask::kPlay || start.task == DrillTask::kPredictBall) return true;
    return wallClearance(field_, scene.exercise.target) > robot_.robot.circumradius();
  }

  /// Whether the ball, alone on the field, goes into the own goal with the bounces that the start asks for.
  bool enters(const DrillStart& start, const Placement& placement) {
    ++rolls_;
    const double speed = norm(placement.ball_velocity);
    const BallWay way = rollAlone(match_, placement);
    return way.conceded && (start.bounces < 0 || way.bounces == start.bounces) &&
           way.length >= savableDistance(start, speed);
  }

  bool robotFits(const Pose2& pose, Vec2 ball) const {
    const math::SinCos sc = math::sinCos(pose.heading);
    const double half = robot_.robot.length / 2;
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) {
        const Vec2 corner{sc.cos * x - sc.sin * y, sc.sin * x + sc.cos * y};
        if (!insideField(field_, pose.position + corner, 0.0005)) return false;
      }
    }
    const Vec2 apart = ball - pose.position;
    const double along = std::abs(apart.x * sc.cos + apart.y * sc.sin) - half;
    const double across = std::abs(apart.y * sc.cos - apart.x * sc.sin) - half;
    return std::max(along, across) > robot_.ball.radius;
  }

  const Drill& drill_;
  const MatchConfig& match_;
  const FieldGeometry& field_;
  const RobotPreset& robot_;
  Rng& rng_;
  std::size_t turn_;
  int rolls_ = 0;
};

Vec2 mirrored(Vec2 v) { return {v.x, -v.y}; }

void mirror(DrillScene& scene) {
  Placement& placement = scene.placement;
  placement.ball = mirrored(placement.ball);
  placement.ball_velocity = mirrored(placement.ball_velocity);
  for (auto& team : placement.robots) {
    for (auto& pose : team) {
      if (pose) pose = Pose2{mirrored(pose->position), math::wrapAngle(-pose->heading)};
    }
  }
  scene.exercise.target = mirrored(scene.exercise.target);
  scene.exercise.heading = math::wrapAngle(-scene.exercise.heading);
}

}  // namespace

double leastSavableDistance(const Drill& drill, const RobotModel& robot, double speed) {
  const double acceleration = drill.acceleration_share * RobotPace(robot).acceleration;
  return speed * (drill.latency + std::sqrt(2.0 * kGap / acceleration));
}

Result<DrillScene> drawScene(const Drill& drill, const MatchConfig& match, std::uint64_t seed, int index) {
  const int starts = static_cast<int>(drill.starts.size());
  DrillScene scene;
  scene.start = index % starts;
  const int round = index / starts;
  const DrillStart& start = drill.starts[static_cast<std::size_t>(scene.start)];
  Rng rng(seed, Stream::kDrill,
          (static_cast<std::uint64_t>(drill.number) << 32) + static_cast<std::uint64_t>(index));
  // Four trials in a row share a place: mirrored or not, on either side.
  SceneDraw drawing(drill, match, rng, round / 4);
  int draws = 0;
  while (!drawing.draw(start, scene)) {
    if (stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
    if (drawing.rolls() == kMaxRolls) {
      return fail(
          ErrorCode::kBadInput,
          fmt::format("{}: start '{}': no ball goes into the goal (enters = true)", drill.file, start.name));
    }
    if (++draws == kMaxDraws) {
      return fail(ErrorCode::kBadInput,
                  fmt::format("{}: start '{}' leaves no room for all bodies", drill.file, start.name));
    }
  }
  if (round % 2 == 1) mirror(scene);
  scene.seat = (round / 2) % 2 == 0 ? TeamId::kBlue : TeamId::kYellow;
  return scene;
}

bool placedByReferee(const DrillStart& start, const DrillScene& scene) {
  const auto& own = scene.placement.robots[indexOf(TeamId::kBlue)];
  return start.restart >= 0 &&
         std::none_of(own.begin(), own.end(), [](const auto& pose) { return pose.has_value(); });
}

RestartCall openingOf(const DrillStart& start, const DrillScene& scene, const MatchConfig& match) {
  Stoppage stoppage;
  stoppage.kind = static_cast<RestartKind>(start.restart);
  stoppage.team = start.ours ? scene.seat : other(scene.seat);
  stoppage.ball = seated(scene.placement, scene.seat).ball;
  RestartCall call = makeCall(refereeSetup(match), {}, stoppage);
  // The rule gives a free ball to the team that attacks that half; for other restarts, the drill names the
  // team.
  if (call.kind != RestartKind::kFreeBall) call.team = stoppage.team;
  return call;
}

Placement seated(const Placement& placement, TeamId seat) {
  if (seat == TeamId::kBlue) return placement;
  Placement turned;
  turned.ball = inTeamFrame(Side::kRight, placement.ball);
  turned.ball_velocity = inTeamFrame(Side::kRight, placement.ball_velocity);
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      const auto& pose = placement.robots[indexOf(team)][i];
      if (pose) turned.robots[indexOf(other(team))][i] = inTeamFrame(Side::kRight, *pose);
    }
  }
  return turned;
}

}  // namespace fulbito
