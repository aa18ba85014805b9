#include "replays/render/match/score_board.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/match_clock.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/match/body_drawing.hpp"

namespace fulbito {
namespace {

constexpr double kName = 26, kScore = 42, kClock = 15;  // [units] text sizes
constexpr double kPad = 22;                             // [units]
constexpr double kScoreRoom = 0.13;                     // share of the width, on each side of the middle

bool isMatch(const MatchPictureSpec& spec) {
  return std::any_of(spec.bodies.begin(), spec.bodies.end(),
                     [](const RecordedBody& body) { return body.id.has_value(); });
}

/// Position of the time bar [px].
struct TimeBar {
  double left, right, y, thickness;

  double at(double share) const { return left + (right - left) * std::clamp(share, 0.0, 1.0); }
};

TimeBar barOf(const MatchPlan& plan) {
  const double room = std::max(64 * plan.unit, 40.0);
  return {plan.margin + room, plan.width - plan.margin - room, plan.height - plan.foot / 2,
          std::max(2.0, 4 * plan.unit)};
}

/// A time in a recording of `whole` seconds, as text. Short recordings show tenths of seconds, as minutes are
/// too coarse.
std::string barTime(double seconds, double whole) {
  // Rounded down, like clocks.
  if (whole < 30.0) return fmt::format("{:.1f} s", std::floor(seconds * 10 + 1e-6) / 10);
  const int count = static_cast<int>(std::clamp(std::floor(seconds), 0.0, 1e8));
  return fmt::format("{}:{:02}", count / 60, count % 60);
}

void drawName(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, TeamId team,
              const MatchStyle& style) {
  const double u = plan.unit, size = plan.text(kName), mark = 0.42 * size, pad = kPad * u;
  const bool blue = team == TeamId::kBlue;
  const double y = plan.board / 2, room = plan.width * (0.5 - kScoreRoom) - pad - 3.2 * mark;
  const double side = blue ? 1.0 : -1.0, edge = blue ? pad : plan.width - pad;
  const TeamColours& colours = style.teams[indexOf(team)];
  canvas.fillRectangle({blue ? 0.0 : plan.width - 6 * u, 0.0}, 6 * u, plan.board, colours.body);
  drawTeamMark(canvas, {edge + side * mark, y}, mark * (blue ? 1.0 : 1.2), team, colours.body);
  // The available width is measured with regular letters; bold ones are up to a sixth wider.
  const std::string name = fitted(canvas, spec.names[indexOf(team)], size, 0.84 * room);
  canvas.label({std::round(edge + side * 3.2 * mark), std::round(y + 0.36 * size)}, name,
               {size, style.text, blue ? TextAlign::kLeft : TextAlign::kRight, true});
}

void drawTrialTitle(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                    const MatchStyle& style) {
  const double size = plan.text(kName), small = plan.text(kClock), pad = kPad * plan.unit;
  const double baseline = std::round(plan.board / 2 + 0.36 * size), room = plan.width / 2 - 2 * pad;
  canvas.label({std::round(pad), baseline}, fitted(canvas, spec.names[0], size, 0.84 * room),
               {size, style.text, TextAlign::kLeft, true});
  canvas.label({std::round(plan.width - pad), baseline}, fitted(canvas, spec.names[1], small, 0.7 * room),
               {small, style.dim_text, TextAlign::kRight, false});
}

}  // namespace

void drawBoard(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, const MatchStyle& style) {
  canvas.fillRectangle({0, 0}, plan.width, plan.board, style.panel);
  canvas.fillRectangle({0, plan.board - std::max(1.0, plan.unit)}, plan.width, std::max(1.0, plan.unit),
                       style.rule);
  if (!isMatch(spec)) return drawTrialTitle(canvas, plan, spec, style);
  for (const TeamId team : kTeams) drawName(canvas, plan, spec, team, style);
}

void drawBoardNumbers(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                      const ReplayMoment& moment, const MatchStyle& style) {
  const double middle = plan.width / 2, clock = plan.text(kClock), score = plan.text(kScore);
  if (!isMatch(spec)) {
    canvas.label({std::round(middle), std::round(plan.board / 2 + 0.36 * plan.text(kName))},
                 fmt::format("{:.2f} s", moment.play_seconds),
                 {plan.text(kName), style.text, TextAlign::kCentre, true});
    return;
  }
  const double baseline = std::round(plan.board * 0.56), gap = 0.5 * score;
  canvas.label({middle, baseline - 0.06 * score}, ":", {score, style.dim_text, TextAlign::kCentre, true});
  canvas.label({std::round(middle - gap), baseline}, std::to_string(moment.score[0]),
               {score, style.text, TextAlign::kRight, true});
  canvas.label({std::round(middle + gap), baseline}, std::to_string(moment.score[1]),
               {score, style.text, TextAlign::kLeft, true});
  // All digits of the clock have the same width, so that nothing moves while it runs.
  const double foot = std::round(plan.board * 0.87), space = 0.45 * clock;
  canvas.label({middle - space, foot}, periodName(moment.period),
               {clock, style.dim_text, TextAlign::kRight, false});
  canvas.label({middle + space, foot}, clockText(moment.play_seconds),
               {clock, moment.playing ? style.text : style.dim_text, TextAlign::kLeft, true});
}

void drawTimeBar(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                 const MatchStyle& style) {
  if (!(spec.seconds > 0.0)) return;
  const TimeBar bar = barOf(plan);
  canvas.line({bar.left, bar.y}, {bar.right, bar.y}, bar.thickness, style.rule);
  const double size = plan.text(12);
  canvas.label({std::round(plan.width - plan.margin), std::round(bar.y + 0.36 * size)},
               barTime(spec.seconds, spec.seconds), {size, style.dim_text, TextAlign::kRight, false});
}

double secondsOnBar(const MatchPlan& plan, const MatchPictureSpec& spec, double x) {
  const TimeBar bar = barOf(plan);
  return spec.seconds * std::clamp((x - bar.left) / (bar.right - bar.left), 0.0, 1.0);
}

void drawTimeBarNow(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, double seconds,
                    const MatchStyle& style) {
  const TimeBar bar = barOf(plan);
  const double size = plan.text(12), baseline = std::round(bar.y + 0.36 * size);
  if (!(spec.seconds > 0.0)) return;
  const double now = bar.at(seconds / spec.seconds);
  canvas.line({bar.left, bar.y}, {now, bar.y}, bar.thickness, style.dim_text);
  for (const ReplayGoal& goal : spec.goals) {
    const Vec2 place{bar.at(goal.seconds / spec.seconds), bar.y};
    const double mark = 1.25 * bar.thickness * (goal.team == TeamId::kBlue ? 1.0 : 1.2);
    drawTeamMark(canvas, place, mark + std::max(1.0, 0.25 * bar.thickness), goal.team, style.page);
    drawTeamMark(canvas, place, mark, goal.team, style.teams[indexOf(goal.team)].body);
  }
  canvas.fillCircle({now, bar.y}, 1.5 * bar.thickness, style.text);
  canvas.label({std::round(plan.margin), baseline}, barTime(seconds, spec.seconds),
               {size, style.text, TextAlign::kLeft, false});
}

}  // namespace fulbito
