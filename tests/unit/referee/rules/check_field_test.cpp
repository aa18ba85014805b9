#include "referee/rules/check_field.hpp"

#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

std::string flawOf(const Rules& rules, const FieldGeometry& field) {
  const auto checked = checkField(rules, field, BallModel());
  if (checked) return "";
  CHECK(checked.error().code == ErrorCode::kBadInput);
  return checked.error().message;
}

}  // namespace

TEST_CASE("all presets of rules can be played on their fields", "[unit]") {
  for (const std::string& name : rulesPresetNames()) {
    const Rules rules = *loadRules(name);
    CHECK(flawOf(rules, *loadField(rules.field)) == "");
  }
}

TEST_CASE("a field without room for the ball is named with its key", "[unit]") {
  const Rules rules = *loadRules("vsss-3v3");
  const FieldGeometry whole = *loadField(rules.field);
  const auto with = [&](double FieldGeometry::* key, double value) {
    FieldGeometry field = whole;
    field.*key = value;
    return flawOf(rules, field);
  };
  CHECK(with(&FieldGeometry::goal_width, 0.0).find("goal_width = 0") != std::string::npos);
  CHECK(with(&FieldGeometry::goal_width, 0.04).find("narrower than the ball") != std::string::npos);
  CHECK(with(&FieldGeometry::length, 0.3).find("is not inside") != std::string::npos);
  CHECK(with(&FieldGeometry::penalty_mark, 0.9).find("field.penalty_mark") != std::string::npos);
}

TEST_CASE("what makes a wall is 0 or thick enough", "[unit]") {
  FieldGeometry field;
  for (const double width : {5e-324, 1e-12, 1e-6, 0.009}) {
    field.goal_width = width;
    CHECK_FALSE(validate(field));
  }
  field = {};
  field.corner = 1e-9;
  CHECK_FALSE(validate(field));
  field = {};
  field.goal_depth = 1e-9;
  CHECK_FALSE(validate(field));
  CHECK(validate(FieldGeometry()));
  PhysicsProfile physics;
  physics.wheel_command_step = 1e-9;
  CHECK_FALSE(validate(physics));
}

}  // namespace fulbito
