#include "experiments/papers/plain_floor.hpp"

namespace fulbito {

FieldGeometry plainFloor(const std::string& name, double length, double width) {
  FieldGeometry field;
  field.name = name;
  field.length = length;
  field.width = width;
  field.goal_width = field.goal_depth = field.corner = 0.0;
  field.goal_area_width = field.goal_area_depth = field.goal_area_arc_width = field.goal_area_arc_depth = 0.0;
  field.centre_circle_radius = field.penalty_mark = 0.0;
  field.free_ball_mark = {};
  return field;
}

}  // namespace fulbito
