#include "navigation/methods/hybrid/hybrid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/math/braking.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/methods/fields/limit_cycle.hpp"
#include "navigation/methods/hybrid/room_to_turn.hpp"

namespace fulbito {
namespace {

constexpr int kSectors = 72;           // of the full circle: 36 in the front half
constexpr double kFarAway = 1e3;       // [m]
constexpr double kTurnMargin = 0.045;  // [m] kept from the corners of a turning body, at the paper's robot
constexpr double kPassage = 0.2;       // [m] something so near on both sides is a passage
constexpr double kPassageTurn = 0.2;   // [rad] largest change of direction in a passage
constexpr double kCentring = 6.0;      // [rad/m] turn toward its middle
constexpr double kHullMargin = 0.04;   // [m] room of the emergency rules, likewise

/// The playing rectangle with its corner triangles, counter-clockwise; goals count as closed.
std::array<Vec2, 8> playingContour(const FieldGeometry& field) {
  const double x = field.length / 2, y = field.width / 2, c = field.corner;
  return {{{-x + c, -y},
           {x - c, -y},
           {x, -y + c},
           {x, y - c},
           {x - c, y},
           {-x + c, y},
           {-x, y - c},
           {-x, -y + c}}};
}

EchoMap::Settings mapSettings(double memory) {
  EchoMap::Settings settings;
  settings.memory = memory;
  return settings;
}

constexpr SectorHit kNothing{std::numeric_limits<double>::infinity(), {}};

}  // namespace

Hybrid::Hybrid(const Params& params, HybridVariant variant)
    : params_(params),
      variant_(variant),
      circle_(kSectors),
      memory_(mapSettings(params.memory)),
      seen_(kSectors),
      diagram_(kSectors) {
  if (variant == HybridVariant::kAsPrinted) params_.hold = params_.side_hold = params_.gap_margin = 0.0;
}

void Hybrid::reset() {
  drive_.reset();
  memory_.reset();
  balance_.reset();
  mode_ = HybridMode::kGoal;
  mode_since_ = orbit_last_ = std::numeric_limits<Tick>::min() / 2;
}

Guidance Hybrid::plan(const NavigationScene& scene) {
  if (variant_ != HybridVariant::kOurs || scene.ranges.empty()) return planByRules(scene);
  Guidance guidance;
  guidance.kind = GuidanceKind::kWheels;
  guidance.wheels = inverseKinematics(*scene.robot, drive_.drive(scene));
  return guidance;
}

Guidance Hybrid::planByRules(const NavigationScene& scene) {
  const Situation situation = situationOf(scene);
  const bool may_change = static_cast<double>(scene.tick - mode_since_) * scene.dt >= params_.hold;
  const HybridMode wanted = wantedMode(situation);
  const bool keeps_side = static_cast<double>(scene.tick - orbit_last_) * scene.dt < params_.side_hold;
  if (wanted != mode_ && may_change) changeMode(wanted, situation, scene.tick, keeps_side);
  if (mode_ == HybridMode::kAhead) orbit_last_ = scene.tick;
  const Way way = wayOf(situation, scene);
  direction_ = math::wrapAngle(scene.self.pose.heading + way.direction);
  Guidance guidance = guidanceBy(*this);
  guidance.speed_cap = way.speed_share * scene.robot->maxSpeed();
  if (variant_ != HybridVariant::kAsPrinted)
    guidance.speed_cap = std::min(guidance.speed_cap, brakingSpeed(scene));
  return guidance;
}

void Hybrid::listen(const NavigationScene& scene, const Situation& situation) {
  if (scene.ranges.empty()) {
    readIdeally(scene);
    scanScene(circle_, scene, seen_);
  } else {
    readings_.assign(scene.ranges.begin(), scene.ranges.end());
    if (variant_ == HybridVariant::kAsPrinted) {
      scanReadings();
    } else {
      memory_.update(scene);
      memory_.scan(circle_, scene.self.pose, kFarAway, seen_);
    }
  }
  std::transform(seen_.begin(), seen_.end(), diagram_.begin(), [&](const SectorHit& hit) {
    return hit.distance <= params_.range * situation.scale ? hit : kNothing;
  });
}

/// Every reading fills the sectors that its cone covers, at its range on their bisectors.
void Hybrid::scanReadings() {
  std::fill(seen_.begin(), seen_.end(), kNothing);
  for (const RangeReading& reading : readings_) {
    if (!reading.heard) continue;
    const int last = circle_.sectorOf(reading.mount.heading - reading.half_cone);
    for (int i = circle_.sectorOf(reading.mount.heading + reading.half_cone);; i = circle_.wrap(i + 1)) {
      const Vec2 point = reading.mount.position + circle_.direction(i) * reading.range;
      SectorHit& hit = seen_[static_cast<std::size_t>(circle_.sectorOf(math::angleOf(point)))];
      if (norm(point) > 0.0 && norm(point) < hit.distance) hit = {norm(point), point};
      if (i == last) break;
    }
  }
}

void Hybrid::readIdeally(const NavigationScene& scene) {
  const Vec2 body{scene.robot->length, scene.robot->width};
  if (body != sonars_body_) sonars_ = frontSonars(*scene.robot), sonars_body_ = body;
  const Pose2& pose = scene.self.pose;
  const Vec2 ahead = math::unit(pose.heading);
  known_.clear();
  known_.addRoom(playingContour(*scene.field));
  for (const DiscObstacle& disc : scene.obstacles) known_.addDisc(disc.position, disc.radius);
  readings_.clear();
  for (const SonarSpec& sonar : sonars_) {
    const Cone cone{pose.position + outOfFrame(ahead, sonar.mount.position),
                    outOfFrame(ahead, math::unit(sonar.mount.heading)), sonar.half_cone, sonar.greatest};
    const Echo echo = known_.castCone(cone, math::kPi / 2);
    readings_.push_back({sonar.mount, sonar.half_cone, sonar.greatest, echo.isHeard(),
                         echo.isHeard() ? echo.distance : sonar.greatest});
  }
}

/// What is farther than the goal is not in its way.
void Hybrid::placeEchoes(double goal_range) {
  echoes_.clear();
  for (const RangeReading& reading : readings_) {
    if (!reading.heard) continue;
    const Vec2 echo = reading.mount.position + math::unit(reading.mount.heading) * reading.range;
    if (norm(echo) < goal_range) echoes_.push_back(echo);
  }
  if (variant_ == HybridVariant::kAsPrinted) return;
  for (const SectorHit& hit : diagram_) {
    if (hit.distance < goal_range) echoes_.push_back(hit.point);
  }
}

/// Distance from the body to the nearest point that the diagram shows.
double Hybrid::nearestToBody(const NavigationScene& scene) const {
  const NearnessHull hull{scene.robot->length, scene.robot->width, 0.0};
  double nearest = kFarAway;
  for (const SectorHit& hit : diagram_) {
    if (!hit.isEmpty()) nearest = std::min(nearest, hit.distance - hull.reach(hit.point / hit.distance));
  }
  return nearest;
}

Hybrid::Situation Hybrid::situationOf(const NavigationScene& scene) {
  Situation now;
  now.scale = pioneerScale(*scene.robot);
  const double radius = scene.robot->circumradius();
  now.goal = intoFrame(math::unit(scene.self.pose.heading), scene.goal.position - scene.self.pose.position);
  now.widest_gap = 2.0 * (radius + params_.orbit_margin * now.scale) * params_.crowding;
  listen(scene, now);
  balance_.update(readings_, kPassage * now.scale);
  placeEchoes(norm(now.goal));
  const auto section =
      frontSection(echoes_, {params_.box_width * now.scale, params_.range * now.scale, params_.boxes});
  if (section)
    now.orbit = FrontOrbit{*section, section->width() / 2 + radius + params_.orbit_margin * now.scale};
  if (variant_ != HybridVariant::kWithoutDiagram) {
    now.crowded = isCrowded(circle_, diagram_, now.orbit, {radius, now.widest_gap}) ||
                  nearestToBody(scene) < params_.near_zone * now.scale;
  }
  std::array<double, kTableSonars> ranges;
  ranges.fill(kFarAway);
  for (std::size_t i = 0; i < std::min(ranges.size(), readings_.size()); ++i) {
    if (readings_[i].heard && readings_[i].range < norm(now.goal)) ranges[i] = readings_[i].range;
  }
  now.beside = avoidanceDirection(
      ranges, math::angleOf(now.goal),
      {params_.near * now.scale, params_.far * now.scale, variant_ == HybridVariant::kAsPrinted});
  return now;
}

HybridMode Hybrid::wantedMode(const Situation& situation) const {
  if (situation.crowded) return HybridMode::kCrowded;
  if (situation.orbit) return HybridMode::kAhead;
  return situation.beside ? HybridMode::kBeside : HybridMode::kGoal;
}

void Hybrid::changeMode(HybridMode wanted, const Situation& situation, Tick tick, bool keeps_side) {
  if (wanted == HybridMode::kAhead && !keeps_side) clockwise_ = passesLeft(situation);
  mode_ = wanted;
  mode_since_ = tick;
}

/// Whether the sonars show more room on the left; the goal's side where both have as much.
bool Hybrid::passesLeft(const Situation& situation) const {
  double excess = 0.0;
  for (std::size_t i = 0; i < readings_.size(); ++i)
    excess += i < readings_.size() / 2 ? readings_[i].range : -readings_[i].range;
  return excess != 0.0 ? excess > 0.0 : situation.goal.y >= 0.0;
}

/// The mode's way, as far as the body has room to turn.
Hybrid::Way Hybrid::wayOf(const Situation& situation, const NavigationScene& scene) const {
  const NearnessHull hull{scene.robot->length, scene.robot->width, kTurnMargin * situation.scale};
  Way way = modeWay(situation, scene);
  if (variant_ == HybridVariant::kAsPrinted) return way;
  way.direction = roomToTurn(seen_, hull, way.direction);
  return way;
}

Hybrid::Way Hybrid::modeWay(const Situation& situation, const NavigationScene& scene) const {
  if (mode_ == HybridMode::kCrowded) return diagramWay(situation, scene);
  if (mode_ == HybridMode::kAhead && situation.orbit) {
    const FrontOrbit& orbit = *situation.orbit;
    return {orbitHeading(-orbit.section.centre(), orbit.radius, params_.mu, clockwise_)};
  }
  if (mode_ != HybridMode::kGoal && situation.beside) return {*situation.beside};
  return {math::angleOf(situation.goal)};
}

Hybrid::Way Hybrid::diagramWay(const Situation& situation, const NavigationScene& scene) const {
  const RobotModel& robot = *scene.robot;
  NearnessView view;
  view.circle = &circle_;
  view.hits = diagram_;
  view.goal = situation.goal;
  view.radius = robot.width / 2 + params_.gap_margin * situation.scale;
  view.security = params_.security * situation.scale;
  const NearnessMotion motion =
      decideNearness(view, {robot.length, robot.width, kHullMargin * situation.scale});
  if (variant_ == HybridVariant::kAsPrinted) return {motion.direction, motion.speed_share};
  const double most = balance_.inPassage() && motion.speed_share > 0.0 ? kPassageTurn : math::kPi / 2;
  const double centring = kCentring / situation.scale * balance_.offset();
  return {std::clamp(motion.direction + centring, -most, most), motion.speed_share};
}

/// The robot can stop before what lies straight ahead.
double Hybrid::brakingSpeed(const NavigationScene& scene) const {
  const double room = roomAhead(seen_, scene.robot->width / 2) - scene.robot->length / 2;
  return stoppingSpeed(params_.braking * scene.robot->wheel_acceleration, std::max(0.0, room));
}

namespace {

template <typename N>
NavigatorInfo infoOf(const char* name, const char* summary) {
  using P = HybridParams;
  NavigatorInfo info = describeNavigator<P, N>(
      name, summary, "P.-G. Kim et al. 2006",
      {number("range", &P::range, 0.5, 5.0, "m",
              "d_max: farthest obstacle that counts, at a robot of 22 cm radius as all lengths"),
       number("security", &P::security, 0.05, 3.0, "m", "d_s: security zone of the nearness diagram"),
       number("near", &P::near, 0.05, 2.0, "m", "I1: the table turns away from nearer obstacles"),
       number("far", &P::far, 0.05, 3.0, "m", "I2: the table averages with the goal up to this distance"),
       number("box_width", &P::box_width, 0.02, 0.3, "m", "width of an occupancy box"),
       integer("boxes", &P::boxes, 1, kMostBoxes, "occupancy boxes on each side"),
       number("orbit_margin", &P::orbit_margin, 0.0, 1.0, "m", "what an orbit adds to the robot's radius"),
       number("mu", &P::mu, 0.1, 20.0, "", "convergence to the orbit"),
       number("crowding", &P::crowding, 0.0, 5.0, "", "gaps below this many robot diameters are crowded"),
       number("near_zone", &P::near_zone, 0.0, 1.0, "m", "anything nearer to the body is crowded"),
       number("hold", &P::hold, 0.0, 2.0, "s", "time for which a behaviour is kept at least"),
       number("side_hold", &P::side_hold, 0.0, 20.0, "s",
              "time after an orbit in which the next keeps its side"),
       number("gap_margin", &P::gap_margin, 0.0, 0.2, "m",
              "added to half the robot's width when a gap is tested"),
       number("braking", &P::braking, 0.1, 1.0, "", "share of the wheel acceleration for stopping"),
       number("memory", &P::memory, 0.1, 60.0, "s", "time for which echoes are remembered")});
  info.reads_ranges = true;
  return info;
}

}  // namespace

NavigatorInfo hybridInfo() {
  return infoOf<Hybrid>("hybrid", "by sonar: what cones prove free, narrow places along their middle");
}

NavigatorInfo hybridWithoutNdInfo() {
  return infoOf<HybridWithoutNd>("hybrid-without-nd", "orbits ahead, a table beside, no nearness diagram");
}

NavigatorInfo hybridRawInfo() {
  return infoOf<HybridRaw>("hybrid-raw", "as printed: orbit, table and nearness diagram on present readings");
}

}  // namespace fulbito
