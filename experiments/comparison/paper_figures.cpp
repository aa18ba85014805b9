#include "experiments/comparison/paper_figures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

std::string times(std::size_t count) { return count == 1 ? "once" : fmt::format("{} times", count); }

/// The trace up to the first touch; the motion after it is an effect of the collision.
std::span<const TraceRow> untouched(const TrialRecord& run) {
  const std::span<const TraceRow> trace = run.trace;
  if (run.touches.empty()) return trace;
  const auto end = std::find_if(trace.begin(), trace.end(),
                                [&](const TraceRow& row) { return row.time >= run.touches.front().time; });
  return trace.first(static_cast<std::size_t>(end - trace.begin()));
}

/// The trace until the robot is `reach` [m] from its start.
std::span<const TraceRow> nearStart(const Layout& layout, std::span<const TraceRow> trace, double reach) {
  const auto end = std::find_if(trace.begin(), trace.end(), [&](const TraceRow& row) {
    return distance(row.robot.pose.position, layout.start.position) >= reach;
  });
  return trace.first(static_cast<std::size_t>(end - trace.begin()));
}

FigureVerdict fails(const TrialRecord& run) {
  if (!run.score.arrived)
    return {true, fmt::format("never reaches the ball ({})", nameOf(run.score.outcome))};
  return {false, fmt::format("reaches the ball after {:.2f} s, {:.1f} times the least time", run.score.time,
                             run.score.timeRatio())};
}

FigureVerdict touches(const char* what, int count, const TrialRecord& run) {
  if (count > 0) return {true, fmt::format("touches {} {}", what, times(static_cast<std::size_t>(count)))};
  return {false, fmt::format("touches {} never, least gap {:.0f} mm", what, 1000 * run.score.min_clearance)};
}

FigureVerdict turns(const FigureCase& figure, const TrialRecord& run) {
  std::vector<long> angles;  // [degrees] of the turns that are abrupt enough
  for (const HeadingTurn& turn : turnsOf(untouched(run), figure.turn, figure.within)) {
    if (turn.abrupt >= figure.turn) angles.push_back(std::lround(turn.angle * 180.0 / math::kPi));
  }
  const auto count = static_cast<int>(angles.size());
  std::string measured = count == 1
                             ? "makes one such turn"
                             : fmt::format("makes {} such turns", count == 0 ? "no" : std::to_string(count));
  if (count > 0) measured += fmt::format(" ({} degrees)", fmt::join(angles, ", "));
  return {count >= figure.times, std::move(measured)};
}

FigureVerdict turnsBack(const FigureCase& figure, const Layout& layout, const TrialRecord& run) {
  const auto all = turnsOf(nearStart(layout, run.trace, figure.near), figure.turn);
  const bool shown = all.size() >= 2 && all[0].angle < 0.0;
  std::string measured = all.empty() ? "leaves without a turn" : "turns";
  for (std::size_t i = 0; i < std::min<std::size_t>(all.size(), 3); ++i) {
    measured += fmt::format("{} {:.0f} degrees {}", i == 0 ? "" : ", then",
                            std::abs(all[i].angle) * 180.0 / math::kPi,
                            all[i].angle < 0.0 ? "clockwise" : "counterclockwise");
  }
  return {shown, std::move(measured)};
}

FigureVerdict bentBehind(const FigureCase& figure, const Layout& layout, const TrialRecord& run) {
  const Vec2 along = unitOr(layout.goal - layout.start.position, {1.0, 0.0});
  double passed = 0.0;  // [m] along the line start - goal, of the last obstacle
  for (const ObstacleSpec& o : layout.obstacles) {
    passed = std::max(passed, dot(o.pose.position - layout.start.position, along));
  }
  const double off = detourOf(layout, run.trace, passed, 1e9, true);
  return {off >= figure.off,
          fmt::format("is {:.1f} cm above the straight line behind the last obstacle", 100 * off)};
}

FigureVerdict drivesAway(const FigureCase& figure, const Layout& layout, const TrialRecord& run) {
  double way = 0.0;
  for (std::size_t i = 1; i < run.trace.size(); ++i) {
    const Pose2 &now = run.trace[i].robot.pose, &before = run.trace[i - 1].robot.pose;
    const bool away = dot(math::unit(before.heading), layout.goal - before.position) < 0.0;
    way += away ? distance(now.position, before.position) : 0.0;
  }
  return {way >= figure.off, fmt::format("drives {:.1f} cm while it faces away from the ball", 100 * way)};
}

std::optional<std::size_t> placeOf(const ComparisonBlock& block, const std::string& text) {
  for (std::size_t n = 0; n < block.navigators.size(); ++n) {
    if (block.navigators[n].text == text) return n;
  }
  return std::nullopt;
}

/// The verdicts of the figure's runs in the block's record number `i`.
FigureRow judged(const Comparison& comparison, std::size_t b, std::size_t i, const FigureCase& figure,
                 const Layout& layout) {
  FigureRow row{&figure, comparison.blocks[b].speed, 0.0, {}};
  for (const FigureRun& run : figure.runs) {
    const auto n = placeOf(comparison.blocks[b], run.navigator);
    if (!n) continue;
    const TrialRecord& record = recordsOf(comparison, b, *n)[i];
    if (!record.trace.empty()) row.runs.push_back({&run, judgeRun(figure, layout, record)});
  }
  return row;
}

bool hasJudged(const FigureRow& row) {
  return std::any_of(row.runs.begin(), row.runs.end(), [](const JudgedRun& r) { return r.run->judged; });
}

}  // namespace

namespace {

FigureVerdict verdictBy(const FigureCase& figure, const Layout& layout, const TrialRecord& run) {
  switch (figure.rule) {
    case FigureRule::kFails:
      return fails(run);
    case FigureRule::kTouchesObstacle:
      return touches("an obstacle", run.score.obstacle_contacts, run);
    case FigureRule::kTouchesWall:
      return touches("the wall", run.score.wall_contacts, run);
    case FigureRule::kTurns:
      return turns(figure, run);
    case FigureRule::kTurnsBack:
      return turnsBack(figure, layout, run);
    case FigureRule::kBentBehind:
      return bentBehind(figure, layout, run);
    case FigureRule::kDrivesAway:
      return drivesAway(figure, layout, run);
  }
  return {};
}

bool isAboutTouches(FigureRule rule) {
  return rule == FigureRule::kTouchesObstacle || rule == FigureRule::kTouchesWall;
}

}  // namespace

FigureVerdict judgeRun(const FigureCase& figure, const Layout& layout, const TrialRecord& run) {
  FigureVerdict verdict = verdictBy(figure, layout, run);
  if (!isAboutTouches(figure.rule) && !run.touches.empty()) {
    verdict.measured += fmt::format("; touches something {}", times(run.touches.size()));
  }
  return verdict;
}

const FigureCase* figureOf(const std::string& layout) {
  const auto& figures = paperFigures();
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const FigureCase& figure) { return figure.layout.name == layout; });
  return found == figures.end() ? nullptr : &*found;
}

std::vector<std::string> figureMethods() {
  std::vector<std::string> methods;
  const auto add = [&](const std::string& text) {
    if (std::find(methods.begin(), methods.end(), text) == methods.end()) methods.push_back(text);
  };
  for (const FigureCase& figure : paperFigures()) {
    for (const FigureRun& run : figure.runs) add(run.navigator);
  }
  add(kDefaultNavigator);
  return methods;
}

std::string_view verdictOf(const FigureRow& row) {
  int judged = 0, shown = 0;
  for (const JudgedRun& run : row.runs) {
    judged += run.run->judged ? 1 : 0;
    shown += run.run->judged && run.verdict.shown ? 1 : 0;
  }
  return shown == 0 ? "no" : shown == judged ? "yes" : "partly";
}

std::vector<FigureRow> judgeFigures(const Comparison& comparison) {
  std::vector<FigureRow> rows;
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    const auto records = recordsOf(comparison, b, 0);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const Layout layout = block.suite->layout(block.seed, records[i].index);
      const FigureCase* figure = figureOf(layout.name);
      if (figure == nullptr) continue;
      FigureRow row = judged(comparison, b, i, *figure, layout);
      if (hasJudged(row)) rows.push_back(std::move(row));
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FigureRow& a, const FigureRow& b) { return a.figure < b.figure; });
  return rows;
}

std::vector<FigureRow> judgeSweeps(const Comparison& comparison) {
  std::vector<FigureRow> rows;
  for (std::size_t b = 0; b < comparison.blocks.size(); ++b) {
    const ComparisonBlock& block = comparison.blocks[b];
    if (block.suite->name != "sweeps") continue;
    const auto records = recordsOf(comparison, b, 0);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const SweepPlace place = sweepPlace(records[i].index);
      FigureRow row =
          judged(comparison, b, i, *place.figure, block.suite->layout(block.seed, records[i].index));
      row.value = place.value;
      if (hasJudged(row)) rows.push_back(std::move(row));
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FigureRow& a, const FigureRow& b) { return a.figure < b.figure; });
  return rows;
}

namespace {

/// A place on a trace: path length [m] and unwrapped heading [rad], both relative to the trace's first row.
struct Place {
  double way = 0.0;
  double heading = 0.0;
};

std::vector<Place> placesOf(std::span<const TraceRow> trace) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const Pose2 &now = trace[i].robot.pose, &before = trace[i == 0 ? 0 : i - 1].robot.pose;
    const Place last = i == 0 ? Place{} : places.back();
    places.push_back({last.way + distance(now.position, before.position),
                      last.heading + math::wrapAngle(now.heading - before.heading)});
  }
  return places;
}

/// Indices of the start of the first turn of more than `least` [rad], and of the end of each alternating
/// turn.
std::vector<std::size_t> turningPoints(const std::vector<Place>& places, double least) {
  std::vector<std::size_t> points;
  std::size_t low = 0, high = 0;  // rows of least and greatest heading since the last turn began
  double sense = 0.0;             // direction of the last turn
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double heading = places[i].heading;
    const bool right = sense >= 0.0 && places[high].heading - heading > least;
    const bool left = sense <= 0.0 && heading - places[low].heading > least;
    if (right || left) {
      if (points.empty()) points.push_back(right ? high : low);
      points.push_back(i);
      sense = right ? -1.0 : 1.0;
      (right ? low : high) = i;
    }
    if (heading < places[low].heading) low = i;
    if (heading > places[high].heading) high = i;
    if (sense != 0.0) points.back() = sense > 0.0 ? high : low;
  }
  return points;
}

/// The greatest change of heading [rad] in the direction `sense` within `within` [m] of path.
double steepest(std::span<const Place> places, double within, double sense) {
  double most = 0.0;
  for (std::size_t a = 0, z = 0; a < places.size(); ++a) {
    while (z + 1 < places.size() && places[z + 1].way - places[a].way <= within) ++z;
    most = std::max(most, sense * (places[z].heading - places[a].heading));
  }
  return most;
}

}  // namespace

std::vector<HeadingTurn> turnsOf(std::span<const TraceRow> trace, double least, double within) {
  const std::vector<Place> places = placesOf(trace);
  const std::vector<std::size_t> points = turningPoints(places, least);
  std::vector<HeadingTurn> turns;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double angle = places[points[k]].heading - places[points[k - 1]].heading;
    const auto part = std::span(places).subspan(points[k - 1], points[k] - points[k - 1] + 1);
    turns.push_back({angle, steepest(part, within, angle < 0.0 ? -1.0 : 1.0)});
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
