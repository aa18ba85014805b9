#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "fulbito/detail/echo_scene.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/sonar_model.hpp"
#include "fulbito/report.hpp"
#include "navigation/methods/fields/limit_cycle.hpp"
#include "navigation/methods/hybrid/avoidance_table.hpp"
#include "navigation/methods/hybrid/occupancy_boxes.hpp"
#include "navigation/methods/reactive/nearness_motion.hpp"

namespace fulbito {
namespace {

constexpr double kFarAway = std::numeric_limits<double>::infinity();
// The paper's section V: number of sectors, and ranges in m. The paper does not print I1 and I2; these are
// the values of the hybrid method.
constexpr int kSectors = 36;
constexpr double kRange = 1.5, kSecurity = 0.8;
constexpr AvoidanceRanges kTableRanges{0.3, 0.6};
constexpr double kSide = 0.311;  // [m] side of the square whose circumradius is the paper's 0.22 m
constexpr double kArrow = 0.75;  // [m] drawn length of a direction

/// The content of a picture: a floor [m] and the robot's place on it.
struct Frame {
  double length, width;
  Vec2 robot;
};
constexpr Frame kRound{4.3, 3.3, {-0.4, 0.0}}, kZone{3.3, 2.3, {-0.5, 0.0}}, kAhead{2.4, 1.5, {-0.85, 0.0}};

struct DiscObstacle {
  Vec2 centre;  // [m] in the robot's frame
  double radius;
};

RobotModel paperRobot() {
  RobotModel robot;
  robot.length = robot.width = kSide;
  return robot;
}

/// A picture whose robot points to the right, and everything relative to it.
class Still {
 public:
  Still(const Frame& frame, std::string name, std::string title, std::vector<DiscObstacle> discs, Vec2 goal)
      : robot_(frame.robot), discs_(std::move(discs)), goal_(goal) {
    scene_.name = std::move(name);
    scene_.page.title = std::move(title);
    scene_.page.field = plainFloor("floor", frame.length, frame.width);
    scene_.page.rate = 1.0;
    scene_.page.drawing_ticks = 1;
    scene_.labels = {"robot"};
    scene_.page.bodies = {{BodyKind::kRobot, {}, false, 0.0, 0.0, kPioneerRadius}};
    scene_.page.rows = {{0, {{robot_, 0.0}}}};
    for (const DiscObstacle& disc : discs_) {
      scene_.page.bodies.push_back({BodyKind::kObstacle, {}, false, 0.0, 0.0, disc.radius});
      scene_.page.rows.front().poses.push_back({robot_ + disc.centre, 0.0});
    }
    text(goal_ + Vec2{0.0, 0.09}, "goal");
    ring(goal_, 0.05);
  }

  const std::vector<DiscObstacle>& discs() const { return discs_; }
  Vec2 goal() const { return goal_; }
  void text(Vec2 at, const std::string& words) {
    RecordedDrawing drawing;
    drawing.kind = RecordedDrawing::Kind::kText;
    drawing.from = robot_ + at;
    drawing.text = words;
    scene_.page.drawings.push_back(drawing);
  }
  void ring(Vec2 centre, double radius) {
    RecordedDrawing drawing;
    drawing.kind = RecordedDrawing::Kind::kCircle;
    drawing.from = robot_ + centre;
    drawing.radius = radius;
    scene_.page.drawings.push_back(drawing);
  }
  void line(Vec2 from, Vec2 to) {
    RecordedDrawing drawing;
    drawing.from = robot_ + from;
    drawing.to = robot_ + to;
    scene_.page.drawings.push_back(drawing);
  }
  void path(std::string label, std::vector<Vec2> points, bool dashed = false) {
    for (Vec2& point : points) point += robot_;
    scene_.paths.push_back({std::move(label), std::move(points), dashed});
  }
  void direction(std::string label, double bearing, bool dashed = false) {
    path(std::move(label), {{0.0, 0.0}, math::unit(bearing) * kArrow}, dashed);
  }
  ReportScene finished(std::string caption) {
    scene_.caption = std::move(caption);
    finishScene(scene_);
    return std::move(scene_);
  }

 private:
  Vec2 robot_;  ///< [m] in the picture
  ReportScene scene_;
  std::vector<DiscObstacle> discs_;
  Vec2 goal_;
};

/// What the diagram sees in a picture, within its range.
struct Seen {
  SectorCircle circle{kSectors};
  std::vector<SectorHit> hits;
  NearnessView view;

  explicit Seen(const Still& still) : hits(kSectors, SectorHit{kFarAway, {}}) {
    for (const DiscObstacle& disc : still.discs()) scanDisc(circle, disc.centre, disc.radius, hits);
    for (SectorHit& hit : hits) {
      if (hit.distance > kRange) hit = {kFarAway, {}};
    }
    view = {&circle, hits, still.goal(), kPioneerRadius, kSecurity, WideRegionRule::kCorner};
  }
  double range(int sector) const {
    return std::min(hits[static_cast<std::size_t>(circle.wrap(sector))].distance, kRange);
  }
};

/// The nearest obstacle of each sector as a closed line.
void drawDiagram(const Seen& seen, Still& still) {
  std::vector<Vec2> outline;
  for (int i = 0; i < kSectors; ++i) {
    outline.push_back(seen.circle.edge(i) * seen.range(i));
    outline.push_back(seen.circle.edge(seen.circle.wrap(i + 1)) * seen.range(i));
  }
  outline.push_back(outline.front());
  still.path("nearest obstacle per sector, of 36", std::move(outline));
}

ReportScene walkingArea() {
  Still still(kRound, "fig-1", "Fig. 1: gaps and the free walking area",
              {{{1.0, 0.0}, 0.25}, {{0.35, 1.1}, 0.2}, {{0.75, -0.8}, 0.2}, {{-0.9, 0.5}, 0.2}}, {2.1, 0.25});
  const Seen seen(still);
  drawDiagram(seen, still);
  // A gap is a jump of more than 2 R between neighbouring sectors.
  for (int i = 0; i < kSectors; ++i) {
    const double a = seen.range(i - 1), b = seen.range(i);
    if (std::abs(a - b) > 2 * kPioneerRadius) still.ring(seen.circle.edge(i) * std::min(a, b), 0.045);
  }
  const WalkingArea area = findWalkingArea(seen.view);
  if (area.found && !area.goal_inside) {
    const Vec2 near = seen.circle.direction(area.near_border), far = seen.circle.direction(area.far_border);
    still.path("free walking area", {near * kRange, {0.0, 0.0}, far * kRange}, true);
    still.text(near * (kRange + 0.12), "S_rd");
    still.text(far * (kRange + 0.12), "S_od");
    still.direction("its direction", areaDirection(seen.view, area));
  }
  return still.finished(
      "Rings: gaps, where the range jumps by more than the robot's diameter. The area is the region next to "
      "the "
      "goal through which the robot fits: from its nearest sector S_rd to its farthest S_od.");
}

ReportScene lowSafety(const char* name, const char* title, std::vector<DiscObstacle> discs) {
  Still still(kZone, name, title, std::move(discs), {1.8, 0.0});
  const Seen seen(still);
  const NearnessMotion motion = decideNearness(seen.view, {kSide, kSide, 0.01});
  const double wanted = math::angleOf(still.goal());
  still.ring({0.0, 0.0}, kPioneerRadius + kSecurity);
  for (const DiscObstacle& disc : still.discs()) {
    const bool left = disc.centre.y > 0.0;
    still.text(disc.centre + Vec2{0.0, left ? 0.3 : -0.36}, left ? "S_ml" : "S_mr");
  }
  still.direction("toward the goal", wanted, true);
  still.direction("S_theta, the direction driven", motion.direction);
  const char* situation = motion.situation == NearnessSituation::kLs2 ? "LS2, obstacles on both sides"
                                                                      : "LS1, obstacles on one side";
  return still.finished(
      fmt::format("Ring: the security zone of 0.8 m about the robot. Situation {} of the way; it turns by "
                  "{:.0f} degrees.",
                  situation, math::wrapAngle(motion.direction - wanted) * 180 / math::kPi));
}

/// The reading of one of the paper's sonars in a picture.
struct Heard {
  SonarSpec sonar;
  bool heard;
  double range;

  Vec2 place() const { return sonar.mount.position + math::unit(sonar.mount.heading) * range; }
};

std::vector<Heard> listen(const Still& still) {
  EchoScene scene;
  for (const DiscObstacle& disc : still.discs()) scene.addDisc(disc.centre, disc.radius);
  std::vector<Heard> all;
  for (const SonarSpec& sonar : frontSonars(paperRobot())) {
    const Echo echo = scene.castCone(
        {sonar.mount.position, math::unit(sonar.mount.heading), sonar.half_cone, sonar.greatest}, 0.5236);
    all.push_back({sonar, echo.isHeard(), echo.isHeard() ? echo.distance : sonar.greatest});
  }
  return all;
}

void drawCones(const std::vector<Heard>& all, Still& still) {
  for (const Heard& one : all) {
    if (!one.heard) continue;
    const Vec2 from = one.sonar.mount.position;
    for (const double side : {-1.0, 1.0})
      still.line(from, from + math::unit(one.sonar.mount.heading + side * one.sonar.half_cone) * one.range);
  }
}

std::vector<Vec2> echoesOf(const std::vector<Heard>& all) {
  std::vector<Vec2> echoes;
  for (const Heard& one : all) {
    if (one.heard) echoes.push_back(one.place());
  }
  return echoes;
}

/// A board across the way.
std::vector<DiscObstacle> obstacleAhead() {
  return {{{0.95, -0.14}, 0.06},
          {{0.95, -0.04}, 0.06},
          {{0.95, 0.06}, 0.06},
          {{0.95, 0.16}, 0.06},
          {{0.95, 0.26}, 0.06}};
}

ReportScene occupancyBoxes() {
  Still still(kAhead, "fig-4", "Fig. 4: occupancy boxes", obstacleAhead(), {1.8, 0.0});
  const OccupancyBoxes boxes;
  for (int i = -boxes.per_side; i <= boxes.per_side; ++i)
    still.line({0.0, i * boxes.width}, {boxes.length, i * boxes.width});
  for (const double x : {0.0, boxes.length})
    still.line({x, -boxes.per_side * boxes.width}, {x, boxes.per_side * boxes.width});
  const auto heard = listen(still);
  drawCones(heard, still);
  for (const Vec2 echo : echoesOf(heard)) still.ring(echo, 0.03);
  if (const auto section = frontSection(echoesOf(heard), boxes)) {
    still.path("section of the obstacle", {section->first, section->second});
    still.text(section->centre() + Vec2{-0.08, 0.0}, "C");
  }
  return still.finished(
      "Boxes of 50 mm x 1.5 m ahead of the robot. Small rings: echoes, on the axes of the sonars that hear. "
      "The "
      "section runs between the outermost occupied boxes; C is its middle.");
}

ReportScene limitCycle() {
  Still still(kAhead, "fig-5", "Fig. 5: the limit cycle round the section", obstacleAhead(), {1.8, 0.0});
  const auto heard = listen(still);
  drawCones(heard, still);
  const auto section = frontSection(echoesOf(heard), {});
  if (!section) return still.finished("No obstacle is ahead.");
  const double radius = section->width() / 2 + kPioneerRadius;
  still.ring(section->centre(), radius);
  constexpr double kStep = 0.02, kMu = 2.0;
  for (const bool clockwise : {true, false}) {
    std::vector<Vec2> points{{0.0, 0.0}};
    while (points.size() < 120 && points.back().x < section->centre().x + 0.3) {
      const double heading = orbitHeading(points.back() - section->centre(), radius, kMu, clockwise);
      points.push_back(points.back() + math::unit(heading) * kStep);
    }
    still.path(clockwise ? "clockwise" : "counter-clockwise", std::move(points), !clockwise);
  }
  return still.finished(
      "Ring: the orbit about the section's middle, with half its length and the robot's radius. The robot "
      "goes "
      "to the side on which its sonars hear more room.");
}

ReportScene avoidance(const char* name, const char* title, double distance) {
  Still still(kAhead, name, title, {{math::unit(0.52) * (distance + 0.12 + kPioneerRadius), 0.12}},
              {1.7, 0.45});
  const auto heard = listen(still);
  drawCones(heard, still);
  std::array<double, kTableSonars> ranges;
  ranges.fill(kFarAway);
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (heard[i].heard) ranges[i] = heard[i].range;
    if (ranges[i] < ranges[nearest]) nearest = i;
  }
  const double goal = math::angleOf(still.goal());
  const auto direction = avoidanceDirection(ranges, goal, kTableRanges);
  still.direction("toward the goal", goal, true);
  if (direction) still.direction("direction of the table", *direction);
  return still.finished(
      fmt::format("Sonar {} hears the least range, S = {:.2f} m; I1 = {:.1f} m, I2 = {:.1f} m. {}", nearest,
                  ranges[nearest], kTableRanges.near, kTableRanges.far,
                  ranges[nearest] <= kTableRanges.near
                      ? "The nearer, the farther the robot turns away, whatever the goal."
                      : "The direction lies between the table's and the goal's."));
}

}  // namespace

std::vector<ReportScene> hybridPictures() {
  std::vector<ReportScene> pictures;
  pictures.push_back(walkingArea());
  pictures.push_back(lowSafety("fig-2", "Fig. 2: low safety 1", {{{0.75, 0.38}, 0.15}}));
  pictures.push_back(
      lowSafety("fig-3", "Fig. 3: low safety 2", {{{0.75, 0.38}, 0.15}, {{0.85, -0.52}, 0.15}}));
  pictures.push_back(occupancyBoxes());
  pictures.push_back(limitCycle());
  pictures.push_back(avoidance("fig-6", "Fig. 6: S up to I1", 0.2));
  pictures.push_back(avoidance("fig-7", "Fig. 7: S between I1 and I2", 0.45));
  return pictures;
}

}  // namespace fulbito
