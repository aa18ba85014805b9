#include "experiments/trials/figure_case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/assert.hpp"
#include "engine/core/config/config_document.hpp"
#include "engine/core/config/embedded_files.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedCases();

namespace {

constexpr double kRobotHalf = 0.0375;  // [m] half side of the robot of the cases
constexpr double kFarthest = 2.0;      // [m] limit of lengths
constexpr double kLongestText = 300;
constexpr double kDegree = math::kPi / 180.0;

Schema figureSchema(FigureCase& f, Vec2& low, Vec2& high) {
  return {
      {"title", &f.title, 1, kLongestText, "", "heading", true},
      {"paper", &f.sentence, 1, kLongestText, "", "what the paper's figure shows", true},
      {"rule",
       choice(f.rule, {"fails", "touches-obstacle", "touches-wall", "turns", "turns-back", "bent-behind",
                       "drives-away"}),
       0, 0, "", "what a run must do to show it", true},
      {"times", &f.times, 1, 20, "", "turns"},
      {"turn", Angle{&f.turn}, 0, 180, "", "least angle of a turn"},
      {"within", &f.within, 0.001, 1e9, "m", "of way, for a turn"},
      {"off", &f.off, 0, kFarthest, "m", "the straight line"},
      {"near", &f.near, 0.001, 1e9, "m", "the start"},
      {"window_low", &low, -kFarthest, kFarthest, "m", "of the picture"},
      {"window_high", &high, -kFarthest, kFarthest, "m", "of the picture"},
  };
}

Schema sweepSchema(FigureSweep& s) {
  return {
      {"what", choice(s.kind, {"ball-distance", "obstacle-gap", "wall-gap", "heading"}), 0, 0, "", "", true},
      {"from", &s.from, -360, 360, "m or degrees", "first value", true},
      {"to", &s.to, -360, 360, "m or degrees", "last value", true},
      {"steps", &s.steps, 2, 100, "", "number of values", true},
  };
}

Schema runSchema(FigureRun& run) {
  return {{"navigator", &run.navigator, 1, kLongestText, "", "specification", true},
          {"judged", &run.judged, 0, 0, "", "the paper's statement is about this method"}};
}

/// The point `distance` [m] in front of a robot at `start`.
Vec2 ahead(const Pose2& start, double distance) {
  return start.position + math::unit(start.heading) * distance;
}

}  // namespace

Result<FigureCase> parseFigureCase(std::string_view text, const std::string& origin) {
  FigureCase figure;
  auto layout = parseLayout(text, origin);
  if (!layout) return tl::unexpected<Error>(layout.error());
  figure.layout = std::move(*layout);
  static const std::vector<std::string> kTables{"layout", "start", "goal", "obstacle",
                                                "figure", "run",   "sweep"};
  const auto document = ConfigDocument::parse(text, origin, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  Vec2 low, high;
  if (auto r = document->read("figure", figureSchema(figure, low, high), true); !r) {
    return tl::unexpected<Error>(r.error());
  }
  if (low != high) figure.window = std::pair{low, high};
  if (auto r = document->read("sweep", sweepSchema(figure.sweep), false); !r) {
    return tl::unexpected<Error>(r.error());
  }
  const auto count = document->count("run");
  if (!count) return tl::unexpected<Error>(count.error());
  for (int i = 0; i < *count; ++i) {
    FigureRun run;
    if (auto r = document->readElement("run", i, runSchema(run)); !r) return tl::unexpected<Error>(r.error());
    if (auto known = parseBuiltInNavigator(run.navigator); !known) {
      return document->locate({"run", i, "navigator", ": " + known.error().message});
    }
    figure.runs.push_back(std::move(run));
  }
  return figure;
}

const FigureRun* runOf(const FigureCase& figure, const std::string& navigator) {
  const auto found = std::find_if(figure.runs.begin(), figure.runs.end(),
                                  [&](const FigureRun& run) { return run.navigator == navigator; });
  return found == figure.runs.end() ? nullptr : &*found;
}

const std::vector<FigureCase>& paperFigures() {
  static const std::vector<FigureCase> figures = [] {
    std::vector<FigureCase> parsed;
    for (const EmbeddedFile& file : embeddedCases()) {
      auto figure = parseFigureCase(file.text, std::string(file.name) + ".toml");
      FULBITO_DEMAND(figure.has_value());
      parsed.push_back(std::move(*figure));
    }
    return parsed;
  }();
  return figures;
}

std::string ruleText(const FigureCase& f) {
  const double degrees = f.turn / kDegree;
  switch (f.rule) {
    case FigureRule::kFails:
      return "never reaches the ball";
    case FigureRule::kTouchesObstacle:
      return "touches an obstacle";
    case FigureRule::kTouchesWall:
      return "touches a wall";
    case FigureRule::kTurns:
      return fmt::format("turns by at least {:.0f} degrees{}, at least {} times, without a touch", degrees,
                         f.within < 1.0 ? fmt::format(" within {:.1f} cm of way", 100 * f.within) : "",
                         f.times);
    case FigureRule::kTurnsBack:
      return fmt::format(
          "turns clockwise, then counterclockwise, by at least {:.0f} degrees each, within {:.0f} cm of its "
          "start",
          degrees, 100 * f.near);
    case FigureRule::kBentBehind:
      return fmt::format("is at least {:.0f} cm above the straight line behind the last obstacle",
                         100 * f.off);
    case FigureRule::kDrivesAway:
      return fmt::format("drives at least {:.0f} cm while it faces away from the ball", 100 * f.off);
  }
  return {};
}

double sweepValue(const FigureSweep& sweep, int step) {
  return sweep.from + (sweep.to - sweep.from) * step / (sweep.steps - 1);
}

std::string sweepText(const FigureSweep& sweep, double value) {
  return sweep.kind == SweepKind::kHeading ? fmt::format("{:.0f} degrees", value)
                                           : fmt::format("{:.1f} mm", 1000 * value);
}

std::string_view nameOf(SweepKind kind) {
  switch (kind) {
    case SweepKind::kBallDistance:
      return "distance of the ball from the obstacle's centre";
    case SweepKind::kObstacleGap:
      return "gap between the robot and the obstacle ahead";
    case SweepKind::kWallGap:
      return "gap between the robot and the wall ahead";
    case SweepKind::kHeading:
      break;
  }
  return "heading of the start";
}

Layout sweptLayout(const FigureCase& figure, double value) {
  Layout layout = figure.layout;
  Pose2& start = layout.start;
  switch (figure.sweep.kind) {
    case SweepKind::kBallDistance: {
      const Vec2 obstacle = layout.obstacles.front().pose.position;
      layout.goal = obstacle + unitOr(layout.goal - obstacle, {0.0, -1.0}) * value;
      break;
    }
    case SweepKind::kObstacleGap: {
      ObstacleSpec& obstacle = layout.obstacles.front();
      const Vec2 along = math::unit(start.heading);
      const double aside = cross(along, obstacle.pose.position - start.position);
      obstacle.pose.position = ahead(start, kRobotHalf + value + obstacle.radius) + perp(along) * aside;
      break;
    }
    case SweepKind::kWallGap: {
      const auto field = loadField(layout.field);
      FULBITO_DEMAND(field.has_value());
      const double gap = wallClearance(*field, start.position) - kRobotHalf;
      start.position += nearestWallNormal(*field, start.position) * (value - gap);
      break;
    }
    case SweepKind::kHeading:
      start.heading = math::wrapAngle(value * kDegree);
  }
  return layout;
}

int sweepPlaces() {
  int places = 0;
  for (const FigureCase& figure : paperFigures()) places += figure.sweep.steps;
  return places;
}

SweepPlace sweepPlace(std::uint64_t index) {
  auto left = static_cast<int>(index % static_cast<std::uint64_t>(std::max(sweepPlaces(), 1)));
  for (const FigureCase& figure : paperFigures()) {
    if (left < figure.sweep.steps) return {&figure, sweepValue(figure.sweep, left)};
    left -= figure.sweep.steps;
  }
  return {};
}

}  // namespace fulbito
