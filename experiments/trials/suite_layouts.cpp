#include "experiments/trials/suite_layouts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/random.hpp"
#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {
namespace {

constexpr double kBall = 0.0335;          // [m] radius of a tennis ball
constexpr double kRobotHalf = 0.0375;     // [m] half side of the robot
constexpr double kRobotRadius = 0.05303;  // [m] radius of the robot's circumscribed circle
constexpr double kNear = 0.0865;          // [m] robot against ball; a centre nearer to the line is in the way
constexpr Vec2 kStart{0.12 - 0.75, 0.12 - 0.65};
constexpr Vec2 kGoal{1.38 - 0.75, 1.18 - 0.65};

const FieldGeometry& field() {
  static const FieldGeometry geometry;
  return geometry;
}

double lineDistance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  const double along = std::clamp(dot(p - a, edge) / squaredNorm(edge), 0.0, 1.0);
  return distance(p, a + edge * along);
}

ObstacleSpec disc(Vec2 position, double radius) {
  ObstacleSpec spec;
  spec.pose.position = position;
  spec.radius = radius;
  return spec;
}

/// Distance [m] from `p` to the surface of the nearest obstacle.
double gapTo(const std::vector<ObstacleSpec>& obstacles, Vec2 p) {
  double gap = 1e9;
  for (const ObstacleSpec& o : obstacles) gap = std::min(gap, distance(o.pose.position, p) - o.radius);
  return gap;
}

Vec2 anywhere(Rng& rng, double wall_margin) {
  for (;;) {
    const Vec2 p{rng.uniform(-0.75, 0.75), rng.uniform(-0.65, 0.65)};
    if (wallClearance(field(), p) >= wall_margin) return p;
  }
}

/// Four tennis balls that do not overlap: two in the lower left box of the paper's setting, and two in the
/// upper right.
std::vector<ObstacleSpec> fourBalls(Rng& rng) {
  std::vector<ObstacleSpec> balls;
  while (balls.size() < 4) {
    const Vec2 p = balls.size() < 2 ? Vec2{rng.uniform(0.25, 0.70), rng.uniform(0.20, 0.60)}
                                    : Vec2{rng.uniform(0.80, 1.25), rng.uniform(0.70, 1.10)};
    const Vec2 centred = p - Vec2{0.75, 0.65};
    if (gapTo(balls, centred) >= kBall) balls.push_back(disc(centred, kBall));
  }
  return balls;
}

int ballsNearLine(const Layout& layout) {
  int near = 0;
  for (const ObstacleSpec& o : layout.obstacles) {
    near += lineDistance(o.pose.position, layout.start.position, layout.goal) < kNear ? 1 : 0;
  }
  return near;
}

void headAtGoal(Layout& layout) { layout.start.heading = math::angleOf(layout.goal - layout.start.position); }

Layout named(const char* suite, std::uint64_t index) {
  Layout layout;
  layout.name = std::string(suite) + "-" + std::to_string(index);
  return layout;
}

Layout drawCorner(Rng& rng, const char* suite, std::uint64_t index) {
  Layout layout = named(suite, index);
  layout.start.position = kStart;
  layout.goal = kGoal;
  do {
    layout.obstacles = fourBalls(rng);
  } while (ballsNearLine(layout) < 2);
  headAtGoal(layout);
  return layout;
}

Layout barrierLayout(Rng& rng, const char* suite, std::uint64_t index, double gap) {
  Layout layout = named(suite, index);
  const int count = 9 + static_cast<int>(rng.below(2));
  const double narrow = (field().width - gap - count * 2.0 * kRobotHalf) / count;
  const int open = 1 + static_cast<int>(rng.below(static_cast<std::uint32_t>(count - 1)));
  const double x0 = rng.uniform(-0.15, 0.15);
  double y = -field().width / 2;
  for (int i = 0; i < count; ++i) {
    y += (i == open ? gap : narrow) + kRobotHalf;
    // The two at the gap have equal x, so that the width of the gap is exact. The others have small offsets.
    const double x = i == open || i + 1 == open ? x0 : x0 + rng.uniform(-0.01, 0.01);
    layout.obstacles.push_back(disc({x, y}, kRobotHalf));
    y += kRobotHalf;
  }
  do {
    layout.start.position = anywhere(rng, 0.08);
  } while (layout.start.position.x > x0 - 0.30);
  do {
    layout.goal = anywhere(rng, 0.08);
  } while (layout.goal.x < x0 + 0.25);
  headAtGoal(layout);
  return layout;
}

Layout scatteredLayout(Rng& rng, const char* suite, std::uint64_t index, double gap) {
  Layout layout = named(suite, index);
  layout.start.position = {rng.uniform(-0.65, -0.5), rng.uniform(-0.5, 0.5)};
  layout.goal = {rng.uniform(0.5, 0.65), rng.uniform(-0.5, 0.5)};
  const std::size_t count = 6 + rng.below(5);
  while (layout.obstacles.size() < count) {
    const Vec2 p{rng.uniform(-0.45, 0.45), rng.uniform(-0.6, 0.6)};
    const bool free =
        gapTo(layout.obstacles, p) >= gap + kRobotHalf && wallClearance(field(), p) >= gap + kRobotHalf;
    const bool clear_ends = distance(p, layout.start.position) > 0.15 && distance(p, layout.goal) > 0.15;
    if (free && clear_ends) layout.obstacles.push_back(disc(p, kRobotHalf));
  }
  headAtGoal(layout);
  return layout;
}

Layout clutterLayout(std::uint64_t seed, std::uint64_t index, const char* suite, double widths) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{5} << 32));
  const double gap = widths * 2.0 * kRobotHalf;
  return index % 2 == 0 ? barrierLayout(rng, suite, index, gap) : scatteredLayout(rng, suite, index, gap);
}

/// Adds obstacles with radii of `least` to `most` [m] side by side along x = x0 from `low` to `high` [m]. The
/// slits between them are too narrow for a robot.
void addRow(Rng& rng, Layout& layout, double x0, double low, double high, double least, double most) {
  constexpr double kSlit = 0.03;  // [m] far below the robot's width
  for (double y = low; y + 2.0 * least <= high;) {
    double radius = rng.uniform(least, most);
    // The last obstacle fills the rest.
    if (y + 2.0 * radius + kSlit + 2.0 * least > high) radius = std::min(most, (high - y) / 2);
    layout.obstacles.push_back(disc({x0, y + radius}, radius));
    y += 2.0 * radius + kSlit;
  }
}

/// The same from `high` downward, so that the first obstacle begins exactly at `high`.
void addRowBelow(Rng& rng, Layout& layout, double x0, double low, double high, double least, double most) {
  const std::size_t first = layout.obstacles.size();
  addRow(rng, layout, x0, -high, -low, least, most);
  for (std::size_t i = first; i < layout.obstacles.size(); ++i) layout.obstacles[i].pose.position.y *= -1.0;
}

/// A start pose whose body touches the wall nearest to `toward` and faces it within 20 degrees.
Pose2 facingWall(Rng& rng, Vec2 toward) {
  const Vec2 normal = nearestWallNormal(field(), toward);
  const double off = rng.uniform(-0.35, 0.35);
  const math::SinCos sc = math::sinCos(off);
  const double reach = kRobotHalf * (std::abs(sc.cos) + std::abs(sc.sin)) + 0.0005;
  const Vec2 position = toward + normal * (reach - wallClearance(field(), toward));
  return {position, math::wrapAngle(math::angleOf(-normal) + off)};
}

/// The waypoints of a disc that moves straight and bounces off the walls, for at least `length` [m].
std::vector<Vec2> bouncingPath(Vec2 from, Vec2 direction, double radius, double length) {
  const Vec2 room{field().length / 2 - radius, field().width / 2 - radius};
  std::vector<Vec2> path = {from};
  for (double travelled = 0.0; travelled < length;) {
    const double to_x =
        direction.x != 0.0 ? (std::copysign(room.x, direction.x) - from.x) / direction.x : 1e9;
    const double to_y =
        direction.y != 0.0 ? (std::copysign(room.y, direction.y) - from.y) / direction.y : 1e9;
    const double step = std::min(to_x, to_y);
    from += direction * step;
    travelled += step;
    path.push_back(from);
    if (to_x <= to_y) direction.x = -direction.x;
    if (to_y <= to_x) direction.y = -direction.y;
  }
  return path;
}

void scatterBalls(Rng& rng, Layout& layout, std::size_t count, double keep_clear) {
  while (layout.obstacles.size() < count) {
    const Vec2 p = anywhere(rng, 0.12);
    const bool clear =
        distance(p, layout.start.position) > keep_clear && distance(p, layout.goal) > keep_clear;
    if (clear && gapTo(layout.obstacles, p) > 0.13 + kBall) layout.obstacles.push_back(disc(p, kBall));
  }
}

}  // namespace

Layout cornerLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index);
  return drawCorner(rng, "corner", index);
}

Layout shortLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{2} << 32));
  Layout layout = named("short", index);
  for (;;) {
    layout.obstacles = fourBalls(rng);
    layout.start.position = anywhere(rng, 0.08);
    // Separate statements, since the compiler may reorder draws within one expression.
    const double way = rng.uniform(0.55, 0.75);
    layout.goal = layout.start.position + math::unit(rng.uniform(-math::kPi, math::kPi)) * way;
    const bool on_field = wallClearance(field(), layout.goal) >= 0.08;
    const bool free = gapTo(layout.obstacles, layout.start.position) >= kRobotRadius + 0.02 &&
                      gapTo(layout.obstacles, layout.goal) >= kRobotRadius + 0.02;
    if (on_field && free && ballsNearLine(layout) >= 1) break;
  }
  headAtGoal(layout);
  return layout;
}

Layout closeRangeLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{7} << 32));
  for (;;) {
    Layout layout = drawCorner(rng, "close-range", index);
    const double scale = rng.uniform(0.58, 0.72) / distance(kStart, kGoal);
    layout.start.position = kStart * scale;
    layout.goal = kGoal * scale;
    std::vector<ObstacleSpec> balls;
    bool apart = true;
    for (const ObstacleSpec& ball : layout.obstacles) {
      const Vec2 position = ball.pose.position * scale;
      apart = apart && gapTo(balls, position) >= kBall;
      balls.push_back(disc(position, kBall));
    }
    layout.obstacles = std::move(balls);
    if (apart && gapTo(layout.obstacles, layout.start.position) >= 0.15 - kBall &&
        gapTo(layout.obstacles, layout.goal) >= 0.15 - kBall) {
      return layout;
    }
  }
}

Layout headingLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{3} << 32));
  Layout layout = drawCorner(rng, "heading", index);
  layout.start.heading = rng.uniform(-math::kPi, math::kPi);
  for (;;) {
    layout.goal_heading = rng.uniform(-math::kPi, math::kPi);
    // The approach needs 20 cm of room behind the goal along the wanted heading.
    const Vec2 behind = layout.goal - math::unit(*layout.goal_heading) * 0.20;
    bool free = wallClearance(field(), behind) >= 0.08;
    for (const ObstacleSpec& o : layout.obstacles) {
      free = free && lineDistance(o.pose.position, behind, layout.goal) - o.radius >= kRobotRadius + 0.02;
    }
    if (free) return layout;
  }
}

Layout wallsLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{4} << 32));
  Layout layout = named("walls", index);
  const double sx = rng.below(2) == 0 ? -1.0 : 1.0, sy = rng.below(2) == 0 ? -1.0 : 1.0;
  layout.goal = anywhere(rng, 0.20);
  layout.start.position = anywhere(rng, 0.15);
  switch (index % 4) {
    case 0:  // facing a side wall, away from the goal mouths
      layout.start = facingWall(rng, rng.below(2) == 0 ? Vec2{rng.uniform(-0.55, 0.55), sy * 0.64}
                                                       : Vec2{sx * 0.74, sy * rng.uniform(0.30, 0.45)});
      break;
    case 1:  // facing a corner
      layout.start = facingWall(rng, {sx * 0.70, sy * 0.60});
      break;
    case 2:  // the goal is so near to a wall that the robot just fits
      layout.goal = {rng.uniform(-0.5, 0.5), sy * (0.65 - rng.uniform(0.056, 0.07))};
      break;
    default:
      break;
  }
  while (distance(layout.start.position, layout.goal) < 0.4) layout.goal = anywhere(rng, 0.20);
  scatterBalls(rng, layout, 3, 0.22);
  if (index % 4 == 3) {  // a ball so near to the goal that the goal is within 2 cm of its inflated disc
    for (;;) {
      const double reach = kBall + kRobotRadius + rng.uniform(0.0, 0.02);
      const Vec2 p = layout.goal + math::unit(rng.uniform(-math::kPi, math::kPi)) * reach;
      if (gapTo(layout.obstacles, p) > 0.0 && wallClearance(field(), p) > kBall) {
        layout.obstacles.push_back(disc(p, kBall));
        break;
      }
    }
  }
  if (index % 4 >= 2) headAtGoal(layout);
  return layout;
}

Layout clutter11Layout(std::uint64_t seed, std::uint64_t index) {
  return clutterLayout(seed, index, "clutter-1.1", 1.1);
}
Layout clutter13Layout(std::uint64_t seed, std::uint64_t index) {
  return clutterLayout(seed, index, "clutter", 1.3);
}
Layout clutter16Layout(std::uint64_t seed, std::uint64_t index) {
  return clutterLayout(seed, index, "clutter-1.6", 1.6);
}

Layout uTrapLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{8} << 32));
  Layout layout = named("u-trap", index);
  const double y0 = rng.uniform(-0.15, 0.15), x0 = rng.uniform(0.0, 0.15);
  const double step = 2.0 * kRobotHalf + 0.02;
  const int back = 3 + static_cast<int>(rng.below(2));
  for (int i = 0; i < back; ++i)
    layout.obstacles.push_back(disc({x0, y0 + (i - (back - 1) / 2.0) * step}, kRobotHalf));
  for (int i = 1; i <= 2; ++i) {
    const double edge = ((back - 1) / 2.0 + 0.5) * step;
    layout.obstacles.push_back(disc({x0 - i * step, y0 + edge}, kRobotHalf));
    layout.obstacles.push_back(disc({x0 - i * step, y0 - edge}, kRobotHalf));
  }
  layout.start.position = {rng.uniform(-0.65, -0.45), y0 + rng.uniform(-0.10, 0.10)};
  layout.goal = {rng.uniform(0.45, 0.60), y0 + rng.uniform(-0.10, 0.10)};
  headAtGoal(layout);
  return layout;
}

Layout movingLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{6} << 32));
  Layout layout = named("moving", index);
  layout.start.position = {-0.60, rng.uniform(-0.45, 0.45)};
  layout.goal = {0.60, rng.uniform(-0.45, 0.45)};
  headAtGoal(layout);
  const std::size_t count = 1 + rng.below(5);
  while (layout.obstacles.size() < count) {
    ObstacleSpec o =
        disc({rng.uniform(-0.5, 0.5), rng.uniform(-0.58, 0.58)}, rng.uniform(kRobotHalf, kRobotRadius));
    const Vec2 from = o.pose.position;
    const bool apart = gapTo(layout.obstacles, from) >= o.radius + 0.02;
    if (!apart || distance(from, layout.start.position) < 0.25 || distance(from, layout.goal) < 0.25)
      continue;
    o.motion = ObstacleMotion::kPath;
    o.path_end = PathEnd::kStop;
    o.speed = rng.uniform(0.3, 1.5);
    // The direction crosses the path at 30 degrees or more, up or down.
    const double side = rng.below(2) == 0 ? 1.0 : -1.0;
    o.path = bouncingPath(from, math::unit(side * rng.uniform(math::kPi / 6, math::kPi * 5 / 6)), o.radius,
                          30.0 * o.speed);
    layout.obstacles.push_back(std::move(o));
  }
  return layout;
}

Layout gapLayout(std::uint64_t seed, std::uint64_t index, double widths) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{10} << 32));
  Layout layout = named("gap", index);
  const double half_gap = widths * kRobotHalf, wall = field().width / 2;
  const double x0 = rng.uniform(-0.10, 0.10), y0 = rng.uniform(-0.25, 0.25);
  addRow(rng, layout, x0, y0 + half_gap, wall, kRobotHalf, kRobotHalf);
  addRowBelow(rng, layout, x0, -wall, y0 - half_gap, kRobotHalf, kRobotHalf);
  layout.start.position = {x0 - rng.uniform(0.30, 0.55), y0 + rng.uniform(-0.25, 0.25)};
  do {
    layout.goal = {x0 + rng.uniform(0.25, 0.50), y0 + rng.uniform(-0.25, 0.25)};
  } while (std::abs(layout.start.position.y +
                    (x0 - layout.start.position.x) * (layout.goal.y - layout.start.position.y) /
                        (layout.goal.x - layout.start.position.x) -
                    y0) > 0.20);
  headAtGoal(layout);
  return layout;
}

Layout rowLayout(std::uint64_t seed, std::uint64_t index, double widths) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{11} << 32));
  constexpr double kWayRound = 0.40;  // [m] of free way round each end
  Layout layout = named("row", index);
  const double half_gap = widths * kRobotHalf, end = field().width / 2 - kWayRound;
  const double x0 = rng.uniform(-0.10, 0.10), y0 = rng.uniform(-0.05, 0.05);
  addRow(rng, layout, x0, y0 + half_gap, end, 0.03, 0.08);
  addRowBelow(rng, layout, x0, -end, y0 - half_gap, 0.03, 0.08);
  layout.start.position = {x0 - rng.uniform(0.40, 0.55), y0 + rng.uniform(-0.05, 0.05)};
  layout.goal = {x0 + rng.uniform(0.40, 0.55), y0 + rng.uniform(-0.05, 0.05)};
  headAtGoal(layout);
  return layout;
}

Layout anyRowLayout(std::uint64_t seed, std::uint64_t index) {
  Rng rng(seed, Stream::kLayout, index + (std::uint64_t{12} << 32));
  return rowLayout(seed, index, rng.uniform(1.3, 1.6));
}

namespace {

Layout sonarLayout(std::uint64_t seed, std::uint64_t index, const char* suite, double widths) {
  Layout layout;
  if (index % 3 == 0) layout = gapLayout(seed, index, widths);
  if (index % 3 == 1) {
    Rng rng(seed, Stream::kLayout, index + (std::uint64_t{13} << 32));
    layout = scatteredLayout(rng, suite, index, widths * 2.0 * kRobotHalf);
  }
  if (index % 3 == 2) layout = rowLayout(seed, index, widths);
  layout.name = named(suite, index).name;
  return layout;
}

}  // namespace

Layout sonar11Layout(std::uint64_t seed, std::uint64_t index) {
  return sonarLayout(seed, index, "sonar-1.1", 1.1);
}
Layout sonar13Layout(std::uint64_t seed, std::uint64_t index) {
  return sonarLayout(seed, index, "sonar", 1.3);
}
Layout sonar16Layout(std::uint64_t seed, std::uint64_t index) {
  return sonarLayout(seed, index, "sonar-1.6", 1.6);
}

double distanceBetween(const ObstacleSpec& a, const ObstacleSpec& b) {
  if (a.shape == ObstacleShape::kBox) return clearance(Rectangle{a.pose, a.length, a.width}, b, b.pose);
  if (b.shape == ObstacleShape::kBox) return distanceBetween(b, a);
  return distance(a.pose.position, b.pose.position) - a.radius - b.radius;
}

}  // namespace fulbito
