#include "referee/restart_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "engine/core/math.hpp"
#include "referee/restart_call.hpp"
#include "referee/restart_zone.hpp"

namespace fulbito {
namespace {

constexpr double kLeastGap = 1e-4;   // [m] between bodies of a placement that is accepted as it is
constexpr double kRounding = 1e-9;   // [m]
constexpr double kFarthest = 100.0;  // [m] from the centre a wish is no wish
constexpr double kNoticed = 1e-3;    // [m] shorter repairs, as off a wall that is touched, are not told
constexpr double kSameSpot = 0.01;   // [m] a proposal this near to a place is meant for it
constexpr double kFineStep = 0.01;   // [m] of the search around the wanted place
constexpr int kFineRings = 25;
constexpr double kCoarseStep = 0.04;  // [m] of the search over the whole field

/// A robot of a restart, in the taker's frame.
struct Standing {
  RobotId id;
  RestartPart part;
  PlacedBody body;
  double heading = 0.0;   ///< [rad] world frame
  bool proposed = false;  ///< by its team
  bool changed = false;   ///< the proposal is not what the robot gets
  Vec2 wish;              ///< world frame
};

/// One restart while its robots are placed, one after the other.
class Placer {
 public:
  Placer(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call)
      : setup_(setup), call_(call), mirror_(ownSign(state, call.team)) {
    scene_ = {&setup.rules, &setup.field, call.kind, call.defenders_back, mirrored(call.ball)};
  }

  /// x of the world to x of the frame in which the taker defends +x, and back.
  Vec2 mirrored(Vec2 v) const { return {mirror_ * v.x, v.y}; }
  PlacedBody bodyAt(const Pose2& pose) const {
    return {mirrored(pose.position), mirrored(math::unit(pose.heading)), setup_.robot.length / 2,
            setup_.robot.width / 2};
  }

  /// The team's robots as they wish to stand.
  std::vector<Standing> wishes(TeamId team, const std::optional<TeamPoses>& proposal) const;
  /// Gives each robot its part by where it wishes to stand.
  void assignRoles(std::vector<Standing>& robots) const;
  /// What is wrong with a body among those placed so far; empty: nothing.
  std::string_view fault(RestartPart part, const PlacedBody& body, double gap) const;
  /// Finds the robot's place; false when the field has no room.
  bool settle(Standing& robot);
  /// A finished team, to be judged.
  std::vector<Standing> standing(TeamId team, const TeamPoses& poses) const;
  /// What is wrong with a robot's place; the robot stays there for those that follow.
  std::string_view judge(const Standing& robot);

 private:
  struct Found {
    Vec2 centre;
    double distance = 1e9;
  };
  bool robotsStay() const;
  std::optional<std::size_t> markTaker(TeamId team, const TeamPoses& wishes) const;
  void search(const Standing& robot, bool in_zone, double step, int rings, Found& best) const;

  const RefereeSetup& setup_;
  const RestartCall& call_;
  double mirror_;
  RestartScene scene_;
  std::vector<PlacedBody> placed_;
};

/// Whether a wish is a pose near the field at all.
bool sensible(const Pose2& pose) {
  return isFinite(pose.position) && squaredNorm(pose.position) < kFarthest * kFarthest &&
         std::isfinite(pose.heading);
}

bool Placer::robotsStay() const {
  return call_.kind == RestartKind::kFreeBall && setup_.rules.free_ball.others == FreeBallOthers::kStay;
}

/// Law 14 lets a team choose who takes its mark, and nothing else: the first robot that wishes to.
std::optional<std::size_t> Placer::markTaker(TeamId team, const TeamPoses& wishes) const {
  const double own = team == call_.team ? 1.0 : -1.0;
  const Vec2 mark = scene_.ball + Vec2{own * setup_.rules.free_ball.distance, 0.0};
  for (std::size_t n = 0; n < wishes.size(); ++n) {
    const std::optional<Pose2>& wish = wishes[n];
    if (!wish || !sensible(*wish) || !defaultPoses(call_, team)[n]) continue;
    if (distance(mirrored(wish->position), mark) <= kSameSpot) return n;
  }
  return std::nullopt;
}

std::vector<Standing> Placer::wishes(TeamId team, const std::optional<TeamPoses>& proposal) const {
  std::vector<Standing> robots;
  const bool fixed = robotsStay();
  const auto taker = fixed && proposal ? markTaker(team, *proposal) : std::nullopt;
  for (std::size_t n = 0; n < kMaxTeamSize; ++n) {
    const auto& own = defaultPoses(call_, team)[n];
    if (!own) continue;
    const Pose2 stay = call_.stays[indexOf(team)][n].value_or(*own);
    Standing robot;
    robot.id = {team, static_cast<std::uint8_t>(n)};
    robot.part.takes = team == call_.team;
    Pose2 pose = taker ? stay : *own;
    if (const std::optional<Pose2> wish = proposal ? (*proposal)[n] : std::nullopt) {
      robot.proposed = true;
      robot.wish = wish->position;
      const bool allowed = !fixed || taker == n || distance(wish->position, pose.position) <= kSameSpot ||
                           distance(wish->position, stay.position) <= kSameSpot;
      robot.changed = !sensible(*wish) || !allowed;
      if (!robot.changed) pose = {wish->position, math::wrapAngle(wish->heading)};
    }
    robot.heading = pose.heading;
    robot.body = bodyAt(pose);
    robots.push_back(robot);
  }
  assignRoles(robots);
  return robots;
}

void Placer::assignRoles(std::vector<Standing>& robots) const {
  if (robots.empty()) return;
  const bool takes = robots.front().part.takes;
  if (takes && (call_.kind == RestartKind::kPenalty || call_.kind == RestartKind::kFreeKick)) {
    // Nobody else may stand between the half-way line and the mark, so the foremost one is the kicker.
    const auto foremost = std::min_element(robots.begin(), robots.end(), [](const auto& a, const auto& b) {
      return a.body.centre.x < b.body.centre.x;
    });
    foremost->part.role = RestartRole::kKicker;
  }
  const double own = takes ? 1.0 : -1.0;
  const Vec2 goal{own * setup_.field.length / 2, 0.0};
  const PlacedBody area = goalAreaBox(setup_.field, own);
  Standing* keeper = nullptr;
  for (Standing& robot : robots) {
    if (robot.part.role == RestartRole::kKicker) continue;
    if (keeper != nullptr) {
      const double mine = distanceTo(area, robot.body.centre), best = distanceTo(area, keeper->body.centre);
      if (mine > best) continue;
      if (mine == best && distance(robot.body.centre, goal) >= distance(keeper->body.centre, goal)) continue;
    }
    keeper = &robot;
  }
  if (keeper != nullptr) keeper->part.role = RestartRole::kKeeper;
}

std::string_view Placer::fault(RestartPart part, const PlacedBody& body, double gap) const {
  if (!onField(setup_.field, body)) return "is not on the field";
  if (distanceTo(body, scene_.ball) < setup_.ball.radius + kLeastGap - kRounding) return "overlaps the ball";
  for (const PlacedBody& other : placed_) {
    if (!apart(body, other, gap - kRounding)) return "overlaps a robot";
  }
  return zoneFault(scene_, part, body);
}

void Placer::search(const Standing& robot, bool in_zone, double step, int rings, Found& best) const {
  const Vec2 base =
      in_zone ? intoZone(scene_, robot.part, robot.body)
              : clampedToField(setup_.field, robot.body.centre, robot.body.reachX(), robot.body.reachY());
  // In the open the role asks for nothing: kGiven's zone is the whole field.
  RestartScene open = scene_;
  if (!in_zone) open.kind = RestartKind::kGiven;
  const double gap = std::max(setup_.rules.restart.robot_gap, kLeastGap);
  PlacedBody body = robot.body;
  const auto try_at = [&](int i, int j) {
    body.centre = base + Vec2{i * step, j * step};
    body.centre = intoZone(open, robot.part, body);
    const double d = distance(body.centre, robot.body.centre);
    if (!(d < best.distance)) return;
    const std::string_view reason = fault(robot.part, body, gap);
    if (reason.empty() || (!in_zone && zoneFault(scene_, robot.part, body) == reason))
      best = {body.centre, d};
  };
  for (int ring = 0; ring <= rings; ++ring) {
    // A farther ring can only hold farther places, but for what the zone's edges move.
    if (best.distance < (ring - 1) * step) return;
    for (int i = -ring; i <= ring; ++i) {
      const int stride = std::abs(i) == ring || ring == 0 ? 1 : 2 * ring;
      for (int j = -ring; j <= ring; j += stride) try_at(i, j);
    }
  }
}

bool Placer::settle(Standing& robot) {
  if (!fault(robot.part, robot.body, kLeastGap).empty()) {
    robot.changed = true;
    Found best;
    const int rings = static_cast<int>(std::max(setup_.field.length, setup_.field.width) / kCoarseStep) + 1;
    search(robot, true, kFineStep, kFineRings, best);
    if (best.distance > 1e8) search(robot, true, kCoarseStep, rings, best);
    // A crowd for which the zone has no room stands elsewhere rather than on top of each other.
    if (best.distance > 1e8) search(robot, false, kCoarseStep, rings, best);
    if (best.distance > 1e8) return false;
    robot.body.centre = best.centre;
  }
  placed_.push_back(robot.body);
  return true;
}

std::vector<Standing> Placer::standing(TeamId team, const TeamPoses& poses) const {
  std::vector<Standing> robots;
  for (std::size_t n = 0; n < poses.size(); ++n) {
    const std::optional<Pose2>& pose = poses[n];
    if (!pose) continue;
    Standing robot;
    robot.id = {team, static_cast<std::uint8_t>(n)};
    robot.part.takes = team == call_.team;
    robot.body = bodyAt(*pose);
    robots.push_back(robot);
  }
  assignRoles(robots);
  return robots;
}

std::string_view Placer::judge(const Standing& robot) {
  if (!defaultPoses(call_, robot.id.team)[robot.id.number]) return "does not take part in this restart";
  const std::string_view reason = fault(robot.part, robot.body, 0.0);
  placed_.push_back(robot.body);
  return reason;
}

std::string_view lawOf(RestartKind kind) {
  constexpr std::string_view laws[] = {"6", "14", "11", "12", "13", ""};
  return laws[static_cast<std::size_t>(kind)];
}

GameEvent repairEvent(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                      const Standing& robot, Vec2 final_place) {
  GameEvent event;
  event.tick = state.last_tick;
  event.play_time = static_cast<double>(state.play_ticks) * setup.dt;
  event.period = static_cast<std::uint8_t>(state.period);
  event.clause = "placement";
  event.law = lawOf(call.kind);
  event.team = robot.id.team;
  event.robot = robot.id.number;
  event.place = final_place;
  event.value = isFinite(robot.wish) ? distance(robot.wish, final_place) : 0.0;
  event.margin = event.value;
  return event;
}

/// Robots with a part of their own choose before the others.
void orderForPlacing(std::vector<Standing>& robots) {
  std::stable_partition(robots.begin(), robots.end(),
                        [](const Standing& robot) { return robot.part.role != RestartRole::kOther; });
}

}  // namespace

Placement place(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                const Proposals& proposals, std::vector<GameEvent>& log) {
  if (call.kind == RestartKind::kGiven) return call.defaults;
  Placer placer(setup, state, call);
  Placement placement;
  placement.ball = call.ball;
  for (const TeamId team : {call.team, other(call.team)}) {
    std::vector<Standing> robots = placer.wishes(team, proposals[indexOf(team)]);
    orderForPlacing(robots);
    for (Standing& robot : robots) {
      const bool stands = placer.settle(robot);
      const Vec2 where = placer.mirrored(robot.body.centre);
      if (stands) placement.robots[indexOf(team)][robot.id.number] = Pose2{where, robot.heading};
      if (robot.proposed && robot.changed && !(distance(robot.wish, where) < kNoticed))
        log.push_back(repairEvent(setup, state, call, robot, where));
    }
  }
  return placement;
}

std::vector<PlacementFlaw> findPlacementFlaws(const RefereeSetup& setup, const RefereeState& state,
                                              const RestartCall& call, const Placement& placement) {
  Placer placer(setup, state, call);
  std::vector<PlacementFlaw> flaws;
  if (placement.ball != call.ball) flaws.push_back({call.team, 0, "the ball is not on its spot"});
  for (const TeamId team : {call.team, other(call.team)}) {
    for (const Standing& robot : placer.standing(team, placement.robots[indexOf(team)])) {
      const std::string_view reason = placer.judge(robot);
      if (!reason.empty()) flaws.push_back({team, robot.id.number, reason});
    }
  }
  return flaws;
}

std::optional<PlacementFlaw> findPlacementFlaw(const RefereeSetup& setup, const RefereeState& state,
                                               const RestartCall& call, const Placement& placement) {
  const std::vector<PlacementFlaw> flaws = findPlacementFlaws(setup, state, call, placement);
  return flaws.empty() ? std::nullopt : std::optional(flaws.front());
}

bool legalPlacement(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                    const Placement& placement) {
  return !findPlacementFlaw(setup, state, call, placement);
}

}  // namespace fulbito
