#include "replays/render/match/match_plan.hpp"

#include <algorithm>
#include <cmath>

#include "replays/render/field/field_drawing.hpp"

namespace fulbito {
namespace {

// Sizes in units, for a picture of 900 x 780.
constexpr double kWidth = 900.0, kHeight = 780.0, kBoard = 84.0, kFoot = 34.0, kMargin = 14.0;
constexpr double kSmallestText = 9.0;  // [px]

Vec2 outerSize(const FieldGeometry& field) {
  const double goals = field.hasGoals() ? field.goal_depth : 0.0;
  return {field.length + 2 * (goals + kDrawnWall), field.width + 2 * kDrawnWall};
}

double footOf(const MatchPictureSpec& spec) { return spec.seconds > 0.0 ? kFoot : kMargin; }

}  // namespace

double MatchPlan::text(double size) const { return std::max(size * unit, kSmallestText); }

MatchPlan planOf(const MatchPictureSpec& spec) {
  MatchPlan plan;
  plan.width = spec.width;
  plan.height = spec.height;
  plan.unit = std::min(plan.width / kWidth, plan.height / kHeight);
  plan.board = kBoard * plan.unit;
  plan.foot = footOf(spec) * plan.unit;
  plan.margin = kMargin * plan.unit;
  const Vec2 outer = outerSize(spec.field);
  const Vec2 room{plan.width - 2 * plan.margin, plan.height - plan.board - plan.foot - plan.margin};
  plan.pixels_per_metre = std::max(1.0, std::min(room.x / outer.x, room.y / outer.y));
  plan.centre = {plan.width / 2, plan.board + plan.margin + room.y / 2};
  return plan;
}

int matchPictureHeight(const FieldGeometry& field, int width) {
  const Vec2 outer = outerSize(field);
  const double unit = width / kWidth;
  const double rest = (kBoard + kFoot + kMargin) * unit;
  const double height = rest + (width - 2 * kMargin * unit) * outer.y / outer.x;
  return static_cast<int>(std::clamp(height, 1.0, 1e6)) / 2 * 2;  // even, as videos need
}

}  // namespace fulbito
