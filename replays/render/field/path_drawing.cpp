#include "replays/render/field/path_drawing.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "replays/render/colours/palette.hpp"

namespace fulbito {
namespace {

using Line = std::vector<Vec2>;  // [px]

// [units] length of a path's turn on top of a bundle.
constexpr double kLongestTurn = 18.0, kShortestTurn = 8.0;
constexpr double kRound = 160.0;  // [units] after this length each path of a bundle should have had a turn
constexpr int kBadgePlaces = 48;  // positions that are tried along a path

std::vector<Line> linesOf(const FieldView& view, const std::vector<DrawnPath>& paths) {
  std::vector<Line> lines;
  for (const DrawnPath& path : paths) {
    Line& line = lines.emplace_back();
    for (Vec2 p : path.points) {
      if (isFinite(p)) line.push_back(view.at(p));
    }
  }
  return lines;
}

double lengthOf(const Line& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

/// Points at equal distances between 8 % and 92 % of the line, because its ends belong to start and goal.
Line badgePlaces(const Line& line) {
  Line places;
  const double length = lengthOf(line);
  double walked = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    while (places.size() < kBadgePlaces) {
      const double wanted = length * (0.08 + 0.84 * static_cast<double>(places.size()) / (kBadgePlaces - 1));
      if (!(step > 0.0) || wanted > walked + step) break;
      places.push_back(line[i - 1] + (line[i] - line[i - 1]) * ((wanted - walked) / step));
    }
    walked += step;
  }
  return places;
}

double nearest(Vec2 p, const Line& others, double limit) {
  double best = limit * limit;
  for (Vec2 q : others) best = std::min(best, squaredNorm(p - q));
  return std::sqrt(best);
}

/// The place of the badge of path `index`: far from other paths and badges. Ties are spread evenly along the
/// path.
Vec2 badgePlace(const std::vector<Line>& places, const Line& taken, std::size_t index, double reach) {
  const Line& mine = places[index];
  Vec2 best = mine.front();
  double best_score = -1e9;
  for (std::size_t k = 0; k < mine.size(); ++k) {
    double free = reach;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i != index) free = nearest(mine[k], places[i], free);
    }
    const double ideal = (static_cast<double>(index) + 1.0) / (static_cast<double>(places.size()) + 1.0);
    const double off = std::abs(static_cast<double>(k) / static_cast<double>(mine.size()) - ideal);
    const double score = free + 2.0 * nearest(mine[k], taken, reach) - 0.5 * reach * off;
    if (score > best_score) best_score = score, best = mine[k];
  }
  return best;
}

void drawBadges(const FieldView& view, const std::vector<DrawnPath>& paths, const std::vector<Line>& lines) {
  std::vector<Line> places;
  places.reserve(lines.size());
  for (const Line& line : lines) places.push_back(badgePlaces(line));
  Line taken;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (places[i].empty()) continue;
    taken.push_back(badgePlace(places, taken, i, 30 * view.unit));
    drawBadge(view, taken.back(), i, pathColour(paths[i], i));
  }
}

void drawFootprints(const FieldView& view, const RobotModel& robot, const DrawnPath& path, Colour colour) {
  for (const Pose2& pose : path.footprints) {
    std::array<Vec2, 4> body = bodyCorners(pose, robot.length, robot.width);
    for (Vec2& p : body) p = view.at(p);
    view.canvas.fillPolygon(body, withAlpha(colour, 22));
    const std::array<Vec2, 5> outline{body[0], body[1], body[2], body[3], body[0]};
    view.canvas.polyline(outline, 1.2 * view.unit, withAlpha(colour, 150));
    const Vec2 nose = pose.position + math::unit(pose.heading) * (robot.length / 2);
    view.canvas.line(view.at(pose.position), view.at(nose), 1.2 * view.unit, withAlpha(colour, 150));
  }
}

/// Draws the lines of `members` with the dashes `each`; then parts of each line again, in turns one dash
/// long.
void drawBundle(const FieldView& view, const std::vector<DrawnPath>& paths, const std::vector<Line>& lines,
                const std::vector<std::size_t>& members, Dashes each) {
  const auto colour_of = [&](std::size_t i) { return pathColour(paths[i], i); };
  const double thickness = pathThickness(view), count = static_cast<double>(members.size());
  for (std::size_t i : members) {
    if (each.on < each.period) {
      drawDashed(view.canvas, lines[i], each, thickness, colour_of(i));
    } else {
      view.canvas.polyline(lines[i], thickness, colour_of(i));
    }
  }
  if (members.size() < 2) return;
  double phase = 0.0;
  for (std::size_t i : members) {
    drawDashed(view.canvas, lines[i], {each.period * count, each.on, phase}, thickness, colour_of(i));
    phase += each.period;
  }
}

void drawLines(const FieldView& view, const std::vector<DrawnPath>& paths, const std::vector<Line>& lines) {
  std::vector<std::size_t> whole, failed;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    view.canvas.polyline(lines[i], pathThickness(view) + 2.4 * view.unit, withAlpha(theme::kPage, 150));
    (paths[i].failed ? failed : whole).push_back(i);
  }
  const double fair = kRound / std::max(1.0, static_cast<double>(whole.size()));
  const double turn = std::clamp(fair, kShortestTurn, kLongestTurn) * view.unit;
  drawBundle(view, paths, lines, whole, {turn, turn});
  drawBundle(view, paths, lines, failed, failedDashes(view));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (paths[i].hollow) drawCore(view, lines[i]);
  }
}

}  // namespace

void drawPaths(const FieldView& view, const RobotModel& robot, const std::vector<DrawnPath>& paths) {
  for (std::size_t i = 0; i < paths.size(); ++i)
    drawFootprints(view, robot, paths[i], pathColour(paths[i], i));
  drawLines(view, paths, linesOf(view, paths));
}

void drawPathMarks(const FieldView& view, const std::vector<DrawnPath>& paths) {
  const std::vector<Line> lines = linesOf(view, paths);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Colour colour = pathColour(paths[i], i);
    if (paths[i].failed && !paths[i].arrived && !lines[i].empty()) {
      drawCross(view, lines[i].back(), 9 * view.unit, colour);
    }
    for (Vec2 touch : paths[i].touches) {
      if (isFinite(touch)) drawTouch(view, view.at(touch), colour);
    }
  }
  drawBadges(view, paths, lines);
}

void drawArrows(const FieldView& view, const FieldArrows& arrows) {
  const Colour colour = withAlpha(theme::kDimText, 130);
  for (const Pose2& place : arrows.places) {
    const Vec2 along = math::unit(place.heading) * (arrows.length / 2);
    const Vec2 tail = view.at(place.position - along), tip = view.at(place.position + along);
    view.canvas.line(tail, tip, 1.2 * view.unit, colour);
    drawArrowHead(view.canvas, tip, unitOr(tip - tail, {1.0, 0.0}), 5 * view.unit, colour);
  }
}

Colour pathColour(const DrawnPath& path, std::size_t index) {
  return seriesColour(path.colour.value_or(index));
}

void drawTouch(const FieldView& view, Vec2 centre, Colour colour) {
  const double u = view.unit;
  view.canvas.fillCircle(centre, 12 * u, withAlpha(theme::kPage, 190));
  view.canvas.circle(centre, 11 * u, 2 * u, theme::kMarker);
  drawCross(view, centre, 6 * u, colour);
}

void drawCore(const FieldView& view, std::span<const Vec2> line) {
  view.canvas.polyline(line, 1.2 * view.unit, theme::kPage);
}

void drawBadge(const FieldView& view, Vec2 centre, std::size_t index, Colour colour) {
  const double u = view.unit;
  view.canvas.fillCircle(centre, 10.5 * u, theme::kPage);
  view.canvas.fillCircle(centre, 9 * u, colour);
  const double brightness = 0.299 * colour.r + 0.587 * colour.g + 0.114 * colour.b;
  view.canvas.text(centre + Vec2{0, 4.2 * u}, std::to_string(index + 1), 12 * u,
                   brightness < 125 ? theme::kMarker : theme::kPage, TextAlign::kCentre);
}

void drawCross(const FieldView& view, Vec2 centre, double size, Colour colour) {
  const Vec2 rising{size, -size}, falling{size, size};
  for (auto [thickness, paint] : {std::pair{7.0, theme::kPage}, std::pair{3.6, colour}}) {
    view.canvas.line(centre - rising, centre + rising, thickness * view.unit, paint);
    view.canvas.line(centre - falling, centre + falling, thickness * view.unit, paint);
  }
}

double pathThickness(const FieldView& view) { return 3.2 * view.unit; }

Dashes failedDashes(const FieldView& view) { return {22 * view.unit, 10 * view.unit}; }

}  // namespace fulbito
