#include "referee/rules/check_field.hpp"

#include <fmt/format.h>

namespace fulbito {

Result<void> checkField(const Rules& rules, const FieldGeometry& field, const BallModel& ball) {
  const auto bad = [&](const std::string& what) {
    return fail(ErrorCode::kBadInput, fmt::format("the rules '{}' cannot be played on the field '{}': {}",
                                                  rules.name, rules.field, what));
  };
  if (!field.hasGoals()) return bad("field.goal_width = 0, it has no goals");
  if (field.goal_width < 2 * ball.radius) {
    return bad(fmt::format("field.goal_width = {} m is narrower than the ball, {} m", field.goal_width,
                           2 * ball.radius));
  }
  // Field and places are symmetric.
  const std::pair<const char*, Vec2> spots[] = {{"goal_kick.ball", rules.goal_kick.ball},
                                                {"free_kick.mark", {rules.free_kick.mark, 0.0}},
                                                {"field.penalty_mark", {field.penalty_mark, 0.0}},
                                                {"field.free_ball_mark", field.free_ball_mark}};
  for (const auto& [key, spot] : spots) {
    if (wallClearance(field, spot) >= ball.radius) continue;
    return bad(fmt::format("{}: a ball at ({}, {}) m is not inside", key, spot.x, spot.y));
  }
  return {};
}

}  // namespace fulbito
