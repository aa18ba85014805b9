#include "experiments/comparison/paper_figures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

// The ring as Figs 1-5 draw it: three radii of a tennis ball, (5) of the paper, and as wide as half of that.
const std::string kRing = "vector-field:offset=0.10,width=0.05,follower=classic";
const std::string kRingPreview = "vector-field:offset=0.10,width=0.05";
const std::string kRingNoEscape = kRing + ",wall_escape=off";
const std::string kCycle = "limit-cycle:follower=classic";
const std::string kCyclePreview = "limit-cycle";
const std::string kBezierMethod = "bezier";

constexpr double kDegree = math::kPi / 180.0;
constexpr double kAbrupt = 20.0 * kDegree;    // a turn that counts in Figs 1 and 6
constexpr double kSwing = 15.0 * kDegree;     // ... and in a corner
constexpr double kSlow = 2.0;                 // times T*
constexpr double kBent = 0.02, kLoop = 0.03;  // [m] off the straight way
constexpr double kLoopReach = 0.25;           // [m] from the start
constexpr double kCornerReach = 0.15;         // [m] from a start in a corner

std::string times(std::size_t count) { return count == 1 ? "once" : fmt::format("{} times", count); }

FigureVerdict abruptTurns(const TrialRecord& run, std::size_t wanted) {
  const std::size_t turns = turnsOf(run.trace, kAbrupt).size();
  return {turns >= wanted, fmt::format("turns by more than 20 degrees {}", times(turns))};
}

FigureVerdict fourTurns(const Layout&, const TrialRecord& run) { return abruptTurns(run, 4); }
FigureVerdict twoTurns(const Layout&, const TrialRecord& run) { return abruptTurns(run, 2); }

FigureVerdict staysAway(const Layout&, const TrialRecord& run) {
  if (!run.score.arrived) return {true, "never reaches the ball"};
  return {run.score.timeRatio() > kSlow,
          fmt::format("reaches the ball after {:.2f} s, {:.2f} times the least time", run.score.time,
                      run.score.timeRatio())};
}

FigureVerdict bentAfterPassing(const Layout& layout, const TrialRecord& run) {
  const Vec2 along = unitOr(layout.goal - layout.start.position, {1.0, 0.0});
  double passed = 0.0;  // [m] along the way, of the last obstacle
  for (const ObstacleSpec& o : layout.obstacles) {
    passed = std::max(passed, dot(o.pose.position - layout.start.position, along));
  }
  const double off = detourOf(layout, run.trace, passed, 1e9, true);
  return {off >= kBent,
          fmt::format("is {:.1f} cm above the straight line behind the last obstacle", 100 * off)};
}

FigureVerdict loopsAtStart(const Layout& layout, const TrialRecord& run) {
  const double off = detourOf(layout, run.trace, -1e9, kLoopReach, false);
  return {off >= kLoop, fmt::format("leaves the straight line by {:.1f} cm while it turns", 100 * off)};
}

FigureVerdict touchesWall(const Layout&, const TrialRecord& run) {
  const int touches = run.score.wall_contacts;
  return {touches > 0, touches > 0
                           ? fmt::format("touches the wall {}", times(static_cast<std::size_t>(touches)))
                           : std::string("leaves without touching the wall")};
}

FigureVerdict swingsInCorner(const Layout& layout, const TrialRecord& run) {
  std::size_t near = 0;
  while (near < run.trace.size() &&
         distance(run.trace[near].robot.pose.position, layout.start.position) < kCornerReach) {
    ++near;
  }
  const auto turns = turnsOf(std::span(run.trace).first(near), kSwing);
  if (turns.size() >= 2)
    return {true, fmt::format("turns back and forth in the corner, {}", times(turns.size()))};
  return {false, "leaves the corner in one turn"};
}

FigureVerdict touchesObstacle(const Layout&, const TrialRecord& run) {
  if (run.score.obstacle_contacts > 0)
    return {true, fmt::format("touches an obstacle {}",
                              times(static_cast<std::size_t>(run.score.obstacle_contacts)))};
  return {false, fmt::format("passes with a least gap of {:.0f} mm", 1000 * run.score.min_clearance)};
}

}  // namespace

const std::vector<FigureClaim>& paperFigures() {
  static const std::vector<FigureClaim> figures = {
      {"fig1-abrupt-turns",
       "Fig. 1: abrupt turns at the obstacles' rings",
       "in a vector field, the path past two obstacles changes its direction abruptly four times",
       kRing,
       {kRingPreview, kBezierMethod},
       std::nullopt,
       fourTurns},
      {"fig2a-ball-in-offset",
       "Fig. 2a: the ball is inside an obstacle's ring",
       "there the vectors point away from the obstacle, and the robot cannot reach the ball",
       kRingPreview,
       {kRing, kBezierMethod},
       std::pair{Vec2{-0.12, -0.20}, Vec2{0.48, 0.26}},
       staysAway},
      {"fig2b-repulsion-after-passing",
       "Fig. 2b: an obstacle repels the robot that has passed it",
       "the robot goes upward, away from its goal, although the obstacle is already behind it",
       kRing,
       {kRingPreview, kBezierMethod},
       std::pair{Vec2{-0.42, -0.20}, Vec2{0.26, 0.18}},
       bentAfterPassing},
      {"fig3-needless-motion",
       "Fig. 3: needless motion of a robot that faces away",
       "a robot that faces away from its unit vector drives a needless loop until the two agree",
       kRing,
       {kRingPreview, kBezierMethod},
       std::pair{Vec2{-0.60, -0.36}, Vec2{-0.08, 0.04}},
       loopsAtStart},
      {"fig4-wall",
       "Fig. 4: leaving a wall",
       "a robot at a wall must turn away with unequal wheel speeds for any heading, which is difficult",
       kRingNoEscape,
       {kRing, kBezierMethod},
       std::pair{Vec2{-0.79, 0.16}, Vec2{-0.37, 0.48}},
       touchesWall},
      {"fig5-corner",
       "Fig. 5: leaving a corner",
       "in a corner the zones of two walls overlap: the robot turns clockwise, then counterclockwise",
       kRingNoEscape,
       {kRing, kBezierMethod},
       std::pair{Vec2{-0.79, 0.37}, Vec2{-0.37, 0.69}},
       swingsInCorner},
      {"fig6-two-turns",
       "Fig. 6: two turns on the way to the limit cycle",
       "a robot that reaches the path of the limit cycle changes its direction twice",
       kCycle,
       {kCyclePreview, kBezierMethod},
       std::nullopt,
       twoTurns},
      {"fig7-close-obstacle",
       "Fig. 7: an obstacle close ahead",
       "a robot that is close to an obstacle and follows the limit cycle collides with it",
       kCycle,
       {kCyclePreview, kBezierMethod},
       std::pair{Vec2{-0.22, -0.16}, Vec2{0.20, 0.16}},
       touchesObstacle},
      {"fig8-close-obstacles",
       "Fig. 8: obstacles close to each other",
       "on the limit cycle of one obstacle the robot runs into the next",
       kCycle,
       {kCyclePreview, kBezierMethod},
       std::pair{Vec2{-0.27, -0.22}, Vec2{0.33, 0.24}},
       touchesObstacle},
  };
  return figures;
}

const FigureClaim* figureOf(const std::string& layout) {
  const auto& figures = paperFigures();
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const FigureClaim& figure) { return figure.layout == layout; });
  return found == figures.end() ? nullptr : &*found;
}

std::vector<std::string> figureMethods() {
  return {kRing, kRingPreview, kRingNoEscape, kCycle, kCyclePreview, kBezierMethod, kDefaultNavigator};
}

std::vector<FigureRow> judgeFigures(const Comparison& comparison) {
  std::vector<FigureRow> rows;
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    for (std::size_t n = 0; n < block.navigators.size(); ++n) {
      for (const TrialRecord& record : recordsOf(comparison, b, n)) {
        const Layout layout = block.suite->layout(block.seed, record.index);
        const FigureClaim* figure = figureOf(layout.name);
        if (figure == nullptr || record.trace.empty() || block.navigators[n].text != figure->method) continue;
        rows.push_back({figure, figure->judge(layout, record)});
      }
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FigureRow& a, const FigureRow& b) { return a.figure < b.figure; });
  return rows;
}

std::vector<double> turnsOf(std::span<const TraceRow> trace, double least) {
  std::vector<double> turns;
  double heading = 0.0, low = 0.0, high = 0.0;  // since the last turn ended, unwrapped
  for (std::size_t i = 1; i < trace.size(); ++i) {
    heading += math::wrapAngle(trace[i].robot.pose.heading - trace[i - 1].robot.pose.heading);
    const double sense = turns.empty() ? 0.0 : turns.back();
    if (sense >= 0.0 && high - heading > least) {  // turned back to the right
      turns.push_back(heading - high);
      low = heading;
    } else if (sense <= 0.0 && heading - low > least) {
      turns.push_back(heading - low);
      high = heading;
    } else if (sense > 0.0 && heading > high) {
      turns.back() += heading - high;
    } else if (sense < 0.0 && heading < low) {
      turns.back() += heading - low;
    }
    low = std::min(low, heading), high = std::max(high, heading);
  }
  return turns;
}

double detourOf(const Layout& layout, std::span<const TraceRow> trace, double from, double to,
                bool left_only) {
  const Vec2 start = layout.start.position, along = unitOr(layout.goal - start, {1.0, 0.0});
  double farthest = 0.0;
  for (const TraceRow& row : trace) {
    const Vec2 way = row.robot.pose.position - start;
    const double place = dot(way, along), side = cross(along, way);
    if (place < from || place > to) continue;
    farthest = std::max(farthest, left_only ? side : std::abs(side));
  }
  return farthest;
}

}  // namespace fulbito
