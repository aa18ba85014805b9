#include "referee/restarts/restart_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "fulbito/detail/math.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/restarts/restart_zone.hpp"

namespace fulbito {
namespace {

constexpr double kLeastGap = 1e-4;   // [m] least gap between bodies in an accepted placement
constexpr double kRounding = 1e-9;   // [m]
constexpr double kFarthest = 100.0;  // [m] from the centre: wishes beyond it are ignored
constexpr double kNoticed = 1e-3;    // [m] shorter repairs, as off a touched wall, are not reported
constexpr double kSameSpot = 0.01;   // [m] a proposal this close to a place means that place
constexpr double kBackStep = 0.005;  // [m] step of the search straight back
constexpr double kFineStep = 0.01;   // [m] step of the search around the wanted place
constexpr int kFineRings = 25;
constexpr double kCoarseStep = 0.04;  // [m] step of the search over the whole field

/// A robot of a restart, in the taker's frame.
struct Standing {
  RobotId id;
  RestartPart part;
  PlacedBody body;
  double heading = 0.0;     ///< [rad] world frame
  bool rests = false;       ///< it stays where it is, by law 14
  bool takes_mark = false;  ///< it takes the mark of law 14
  bool moved_back = false;  ///< law 14 moves it back, since it was too near
  bool changed = false;     ///< its place differs from the wanted one
  Vec2 wish;                ///< the team's wish, or else the rule's place; world frame
};

/// Places the robots of one restart, one after the other.
class Placer {
 public:
  Placer(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call)
      : setup_(setup), call_(call), mirror_(ownSign(state, call.team)) {
    scene_ = {&setup.rules, &setup.field, call.kind, call.defenders_back, mirrored(call.ball)};
  }

  /// Converts x between the world and the frame in which the taker defends +x.
  Vec2 mirrored(Vec2 v) const { return {mirror_ * v.x, v.y}; }
  PlacedBody bodyAt(const Pose2& pose) const {
    return {mirrored(pose.position), mirrored(math::unit(pose.heading)), setup_.robot.length / 2,
            setup_.robot.width / 2};
  }

  /// The team's robots with their wishes.
  std::vector<Standing> wishes(TeamId team, const std::optional<TeamPoses>& proposal) const;
  /// Assigns roles by the robots' wishes.
  void assignRoles(std::vector<Standing>& robots) const;
  /// Places all robots of a team that stay by law 14, and the one that takes the mark.
  void letRest(TeamId team);
  /// Places a robot at its wish without checking for room.
  void stand(const Standing& robot) { placed_.push_back(robot.body); }
  std::size_t standing() const { return placed_.size(); }
  /// Removes the robots that were placed first.
  void removeFirst(std::size_t count) {
    placed_.erase(placed_.begin(), placed_.begin() + static_cast<std::ptrdiff_t>(count));
  }
  /// The flaw of a body among those placed so far; empty: none.
  std::string_view fault(RestartPart part, const PlacedBody& body, double gap) const;
  /// Finds the robot's place; false if the field has no room.
  bool settle(Standing& robot);
  /// The robots of a finished placement, for checking.
  std::vector<Standing> finished(TeamId team, const TeamPoses& poses) const;
  /// The flaw of a robot's place. The robot stays there for the checks that follow.
  std::string_view judge(const Standing& robot);

 private:
  struct Found {
    Vec2 centre;
    double distance = 1e9;
  };
  bool robotsStay() const;
  std::optional<std::size_t> markTaker(TeamId team, const TeamPoses& wishes) const;
  std::optional<std::size_t> defaultTaker(TeamId team) const;
  void takeWish(Standing& robot, const Pose2& wish, Pose2& pose) const;
  bool furtherBack(Standing& robot) const;
  void search(const Standing& robot, bool in_zone, double step, int rings, Found& best) const;

  const RefereeSetup& setup_;
  const RestartCall& call_;
  double mirror_;
  RestartScene scene_;
  std::vector<PlacedBody> placed_;
};

/// Whether a wish is finite and near the field.
bool sensible(const Pose2& pose) {
  return isFinite(pose.position) && squaredNorm(pose.position) < kFarthest * kFarthest &&
         std::isfinite(pose.heading);
}

bool Placer::robotsStay() const {
  return call_.kind == RestartKind::kFreeBall && setup_.rules.free_ball.others == FreeBallOthers::kStay;
}

/// The team's choice for its mark, its only choice by law 14: the first robot that wants it.
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

/// The default robot for the mark: the one whose default place differs from where it would stay.
std::optional<std::size_t> Placer::defaultTaker(TeamId team) const {
  const TeamPoses& stays = call_.stays[indexOf(team)];
  for (std::size_t n = 0; n < stays.size(); ++n) {
    const std::optional<Pose2>& own = defaultPoses(call_, team)[n];
    if (own && stays[n] && own->position != stays[n]->position) return n;
  }
  return std::nullopt;
}

/// The team's wish for a robot, if the law allows a choice.
void Placer::takeWish(Standing& robot, const Pose2& wish, Pose2& pose) const {
  robot.wish = wish.position;
  const bool allowed =
      !robotsStay() || robot.takes_mark || distance(wish.position, pose.position) <= kSameSpot;
  robot.changed = !sensible(wish) || !allowed;
  if (robot.changed || robot.rests || robot.moved_back) return;
  pose = {wish.position, math::wrapAngle(wish.heading)};
}

std::vector<Standing> Placer::wishes(TeamId team, const std::optional<TeamPoses>& proposal) const {
  std::vector<Standing> robots;
  const bool fixed = robotsStay();
  const auto chosen = fixed && proposal ? markTaker(team, *proposal) : std::nullopt;
  const auto taker = chosen ? chosen : defaultTaker(team);
  for (std::size_t n = 0; n < kMaxTeamSize; ++n) {
    const auto& own = defaultPoses(call_, team)[n];
    if (!own) continue;
    const auto& stay = call_.stays[indexOf(team)][n];
    Standing robot;
    robot.id = {team, static_cast<std::uint8_t>(n)};
    robot.part.takes = team == call_.team;
    robot.takes_mark = fixed && taker == n;
    robot.rests = fixed && !robot.takes_mark && call_.rests[indexOf(team)][n];
    robot.moved_back = fixed && !robot.takes_mark && !robot.rests && stay;
    Pose2 pose = robot.takes_mark ? *own : stay.value_or(*own);
    robot.wish = pose.position;
    if (proposal && (*proposal)[n]) takeWish(robot, *(*proposal)[n], pose);
    robot.heading = pose.heading;
    robot.body = bodyAt(pose);
    robots.push_back(robot);
  }
  assignRoles(robots);
  return robots;
}

void Placer::letRest(TeamId team) {
  for (std::size_t n = 0; n < kMaxTeamSize; ++n) {
    if (robotsStay() && call_.rests[indexOf(team)][n]) {
      placed_.push_back(bodyAt(*call_.stays[indexOf(team)][n]));
    }
  }
}

void Placer::assignRoles(std::vector<Standing>& robots) const {
  if (robots.empty()) return;
  const bool takes = robots.front().part.takes;
  if (takes && (call_.kind == RestartKind::kPenalty || call_.kind == RestartKind::kFreeKick)) {
    // Only the kicker may stand between the half-way line and the mark, so the foremost robot is the kicker.
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
  return zoneFlaw(scene_, part, body);
}

void Placer::search(const Standing& robot, bool in_zone, double step, int rings, Found& best) const {
  const Vec2 base =
      in_zone ? intoZone(scene_, robot.part, robot.body)
              : clampedToField(setup_.field, robot.body.centre, robot.body.reachX(), robot.body.reachY());
  // Outside the zone the role does not matter: the zone of kGiven is the whole field.
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
    if (reason.empty() || (!in_zone && zoneFlaw(scene_, robot.part, body) == reason)) best = {body.centre, d};
  };
  for (int ring = 0; ring <= rings; ++ring) {
    // Farther rings hold only farther places, except for shifts at the zone's edges.
    if (best.distance < (ring - 1) * step) return;
    for (int i = -ring; i <= ring; ++i) {
      const int stride = std::abs(i) == ring || ring == 0 ? 1 : 2 * ring;
      for (int j = -ring; j <= ring; j += stride) try_at(i, j);
    }
  }
}

/// Law 14 moves robots straight back, so search there first.
bool Placer::furtherBack(Standing& robot) const {
  const double gap = std::max(setup_.rules.restart.robot_gap, kLeastGap);
  const double own = robot.part.takes ? kBackStep : -kBackStep;
  PlacedBody body = robot.body;
  while (std::abs(body.centre.x) < setup_.field.length / 2) {
    body.centre.x += own;
    if (!fault(robot.part, body, gap).empty()) continue;
    robot.body = body;
    return true;
  }
  return false;
}

bool Placer::settle(Standing& robot) {
  if (!fault(robot.part, robot.body, kLeastGap).empty()) {
    robot.changed = true;
    if (robot.moved_back && furtherBack(robot)) {
      placed_.push_back(robot.body);
      return true;
    }
    Found best;
    const int rings = static_cast<int>(std::max(setup_.field.length, setup_.field.width) / kCoarseStep) + 1;
    search(robot, true, kFineStep, kFineRings, best);
    if (best.distance > 1e8) search(robot, true, kCoarseStep, rings, best);
    // If the zone has no room for a crowd, place robots elsewhere rather than overlapping.
    if (best.distance > 1e8) search(robot, false, kCoarseStep, rings, best);
    if (best.distance > 1e8) return false;
    robot.body.centre = best.centre;
  }
  placed_.push_back(robot.body);
  return true;
}

std::vector<Standing> Placer::finished(TeamId team, const TeamPoses& poses) const {
  std::vector<Standing> robots;
  for (std::size_t n = 0; n < poses.size(); ++n) {
    const std::optional<Pose2>& pose = poses[n];
    if (!pose) continue;
    Standing robot;
    robot.id = {team, static_cast<std::uint8_t>(n)};
    robot.part.takes = team == call_.team;
    robot.rests = restsInPlace(call_, robot.id, *pose);
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

/// Robots that must not move come first, then robots with a special role, then the others.
void orderForPlacing(std::vector<Standing>& robots) {
  const auto first = [&](auto wanted) { std::stable_partition(robots.begin(), robots.end(), wanted); };
  first([](const Standing& robot) { return robot.part.role != RestartRole::kOther; });
  first([](const Standing& robot) { return robot.takes_mark; });
  first([](const Standing& robot) { return robot.rests; });
}

}  // namespace

Placement place(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                const Proposals& proposals, std::vector<GameEvent>& log) {
  if (call.kind == RestartKind::kGiven) return call.defaults;
  Placer placer(setup, state, call);
  Placement placement;
  placement.ball = call.ball;
  // Robots of the other team that stay, except the one for its mark, block the first team.
  placer.letRest(other(call.team));
  const std::size_t waiting = placer.standing();
  for (const TeamId team : {call.team, other(call.team)}) {
    if (team != call.team) placer.removeFirst(waiting);
    std::vector<Standing> robots = placer.wishes(team, proposals[indexOf(team)]);
    orderForPlacing(robots);
    for (Standing& robot : robots) {
      if (robot.rests) placer.stand(robot);
      const bool stands = robot.rests || placer.settle(robot);
      const Vec2 where = placer.mirrored(robot.body.centre);
      if (stands) placement.robots[indexOf(team)][robot.id.number] = Pose2{where, robot.heading};
      if (robot.changed && !(distance(robot.wish, where) < kNoticed))
        log.push_back(repairEvent(setup, state, call, robot, where));
    }
  }
  return placement;
}

bool restsInPlace(const RestartCall& call, RobotId robot, const Pose2& pose) {
  const std::optional<Pose2>& stay = call.stays[indexOf(robot.team)][robot.number];
  return call.rests[indexOf(robot.team)][robot.number] && stay && stay->position == pose.position &&
         stay->heading == pose.heading;
}

std::vector<PlacementFlaw> findPlacementFlaws(const RefereeSetup& setup, const RefereeState& state,
                                              const RestartCall& call, const Placement& placement) {
  Placer placer(setup, state, call);
  std::vector<PlacementFlaw> flaws;
  if (placement.ball != call.ball) flaws.push_back({call.team, 0, "the ball is not on its spot"});
  std::vector<Standing> robots;
  for (const TeamId team : {call.team, other(call.team)}) {
    for (const Standing& robot : placer.finished(team, placement.robots[indexOf(team)])) {
      if (robot.rests) placer.stand(robot);
      if (!robot.rests) robots.push_back(robot);
    }
  }
  for (const Standing& robot : robots) {
    const std::string_view reason = placer.judge(robot);
    if (!reason.empty()) flaws.push_back({robot.id.team, robot.id.number, reason});
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
