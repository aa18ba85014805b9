#include "engine/core/config/schemas.hpp"

namespace fulbito {
namespace {

// Half of the largest field with its goal, plus a margin.
constexpr double kFarthest = 12.0;

constexpr double kLongestLabel = 100;

// A new member of a struct needs a key below, and its size here.
template <typename T, std::size_t labels, std::size_t numbers>
constexpr bool kHasOnly = sizeof(T) == labels * sizeof(std::string) + numbers * sizeof(double);
static_assert(kHasOnly<RobotModel, 1, 28>);
static_assert(kHasOnly<BallModel, 0, 10>);
static_assert(kHasOnly<FieldGeometry, 1, 16>);

}  // namespace

Schema schemaOf(RobotModel& r) {
  return {
      {"name", Label{&r.name}, 1, kLongestLabel, "", "shown in tables and results"},
      {"length", &r.length, 0.01, 1.0, "m", "body along x"},
      {"width", &r.width, 0.01, 1.0, "m", "body along y"},
      {"mass", &r.mass, 0.001, 50.0, "kg", ""},
      {"wheel_radius", &r.wheel_radius, 0.001, 0.5, "m", ""},
      {"axle_track", &r.axle_track, 0.005, 1.0, "m", "between wheel centres"},
      {"max_wheel_speed", &r.max_wheel_speed, 0.1, 1000.0, "rad/s", "limit; faster commands are clamped"},
      {"wheel_acceleration", &r.wheel_acceleration, 0.01, 1000.0, "m/s^2",
       "driving straight, both motors accelerating"},
      {"wheel_braking", &r.wheel_braking, 0.01, 1000.0, "m/s^2", "driving straight, both motors braking"},
      {"yaw_acceleration", &r.yaw_acceleration, 0.0, 1e5, "rad/s^2",
       "turning in place; 0 = from mass and shape"},
      {"rolling_drag", &r.rolling_drag, 0.0, 100.0, "m/s^2",
       "drag that the motors overcome in addition to wheel_acceleration"},
      {"longitudinal_grip", &r.longitudinal_grip, 0.01, 1000.0, "m/s^2", "Coulomb limit along the wheels"},
      {"lateral_grip", &r.lateral_grip, 0.01, 1000.0, "m/s^2", "Coulomb limit across the wheels"},
      {"spin_slow_speed", &r.spin_slow_speed, 0.0, 20.0, "m/s",
       "rim speed of the first measured spin in place; 0 = ideal"},
      {"spin_slow_ratio", &r.spin_slow_ratio, 0.1, 10.0, "", "measured over ideal yaw rate at that speed"},
      {"spin_fast_speed", &r.spin_fast_speed, 0.0, 20.0, "m/s",
       "rim speed of the second measured spin in place"},
      {"spin_fast_ratio", &r.spin_fast_ratio, 0.1, 10.0, "", "measured over ideal yaw rate at that speed"},
      {"wheel_width", &r.wheel_width, 0.0, 0.5, "m", "between a wheel's edges, on which it stands"},
      {"support_distance", &r.support_distance, 0.0, 0.5, "m", "sliding supports before and behind the axle"},
      {"support_sink", &r.support_sink, 0.0, 0.01, "m", "by which contacts with the floor give way at rest"},
      {"support_settling", &r.support_settling, 0.0, 1.0, "s", "in which they do"},
      {"mass_height", &r.mass_height, 0.0, 0.5, "m", "centre of mass above the floor; 0 = stays level"},
      {"ground_clearance", &r.ground_clearance, 0.0, 0.1, "m", "of the body's front and rear edge"},
      {"load_shift", &r.load_shift, 0.0, 1.0, "",
       "share of the load that a curve moves to the outer wheel, by which the wheels' grip changes"},
      {"rim_mass", &r.rim_mass, 0.0, 10.0, "kg", "that accelerates as a wheel's rim does"},
      {"curve_widening", &r.curve_widening, 0.0, 100.0, "s",
       "radius that a curve gains by slip, over the speed; 0 = none"},
      {"curve_widening_rise", &r.curve_widening_rise, 0.0, 100.0, "s^2/m",
       "by which curve_widening rises with the speed"},
      {"friction", &r.friction, 0.0, 10.0, "", "of the body against robots, walls and obstacles"},
      {"restitution", &r.restitution, 0.0, 1.0, "", "of the body against robots, walls and obstacles"},
  };
}

Schema schemaOf(BallModel& b) {
  return {
      {"radius", &b.radius, 0.002, 0.2, "m", ""},
      {"mass", &b.mass, 0.001, 5.0, "kg", "effective in impacts"},
      {"roll_keep", &b.roll_keep, 0.05, 1.0, "", "share of the speed left when sliding becomes rolling"},
      {"slide_deceleration", &b.slide_deceleration, 0.01, 100.0, "m/s^2", "while sliding"},
      {"roll_deceleration", &b.roll_deceleration, 0.0, 100.0, "m/s^2", "while rolling"},
      {"stop_speed", &b.stop_speed, 0.0, 1.0, "m/s", "slower rolling balls stop"},
      {"wall_restitution", &b.wall_restitution, 0.0, 1.0, "", "at a wall, before friction changes the spin"},
      {"wall_spin_keep", &b.wall_spin_keep, 0.0, 1.0, "", "share of the normal spin that survives an impact"},
      {"robot_restitution", &b.robot_restitution, 0.0, 1.0, "", "against robots and obstacles"},
      {"friction", &b.friction, 0.0, 10.0, "", "against everything"},
  };
}

Schema schemaOf(PhysicsProfile& p) {
  return {
      {"name", Label{&p.name}, 1, kLongestLabel, "", "shown in tables and results"},
      {"control_rate", &p.control_rate, 10, 1000, "Hz", "ticks per second for navigators and teams"},
      {"substeps", &p.substeps, 1, 64, "", "physics steps per control tick"},
      {"velocity_iterations", &p.velocity_iterations, 1, 50, "", "of the contact solver"},
      {"position_iterations", &p.position_iterations, 1, 50, "", "of the contact solver"},
      {"bullet_ball", &p.bullet_ball, 0, 0, "", "continuous collision of the ball against moving bodies"},
      {"contact_depth", &p.contact_depth, 0.0, 0.1, "m",
       "steps are split so that bodies overlap no deeper; 0 = never"},
      {"max_ball_speed", &p.max_ball_speed, 0.1, 50.0, "m/s", "up to this speed the ball does not tunnel"},
      {"restitution_threshold", &p.restitution_threshold, 0.0, 10.0, "m/s", "slower impacts do not bounce"},
      {"wheel_command_step", &p.wheel_command_step, 0.0, 10.0, "rad/s", "rounds commands; 0 = not rounded"},
  };
}

Schema schemaOf(FieldGeometry& f) {
  return {
      {"name", Label{&f.name}, 1, kLongestLabel, "", "shown in tables and results"},
      {"length", &f.length, 0.3, 20.0, "m", "x extent"},
      {"width", &f.width, 0.3, 20.0, "m", "y extent"},
      {"goal_width", &f.goal_width, 0.0, 20.0, "m", "width of the mouth; 0 = no goals"},
      {"goal_depth", &f.goal_depth, 0.0, 2.0, "m", "depth behind the goal line"},
      {"corner", &f.corner, 0.0, 10.0, "m", "legs of the corner triangles; 0 = square corners"},
      {"wall_thickness", &f.wall_thickness, 0.005, 1.0, "m", "thickness of the simulated walls"},
      {"goal_area_width", &f.goal_area_width, 0.0, 20.0, "m", "marking; 0 = not drawn"},
      {"goal_area_depth", &f.goal_area_depth, 0.0, 20.0, "m", "marking"},
      {"goal_area_arc_width", &f.goal_area_arc_width, 0.0, 20.0, "m", "chord of the area's arc; 0 = no arc"},
      {"goal_area_arc_depth", &f.goal_area_arc_depth, 0.0, 20.0, "m",
       "reach of the arc beyond the area's front"},
      {"big_area_width", &f.big_area_width, 0.0, 20.0, "m", "penalty area of larger games; 0 = none"},
      {"big_area_depth", &f.big_area_depth, 0.0, 20.0, "m", "penalty area of larger games"},
      {"centre_circle_radius", &f.centre_circle_radius, 0.0, 10.0, "m", "marking; 0 = not drawn"},
      {"penalty_mark", &f.penalty_mark, 0.0, 10.0, "m", "from the centre along x; 0 = not drawn"},
      {"free_ball_mark", &f.free_ball_mark, 0.0, 10.0, "m", "in the first quadrant; [0, 0] = none"},
  };
}

Schema layoutSchema(Layout& l) {
  return {
      {"name", Label{&l.name}, 1, kLongestLabel, "", "shown in tables and results"},
      {"field", &l.field, 1, 4096, "", "preset or file"},
  };
}

Schema startSchema(Layout& l) {
  return {
      {"position", &l.start.position, -kFarthest, kFarthest, "m", "", true},
      {"heading", Heading{&l.start.heading}, -360, 360, "", ""},
  };
}

Schema goalSchema(Layout& l) {
  return {
      {"position", &l.goal, -kFarthest, kFarthest, "m", "", true},
      {"heading", OptionalHeading{&l.goal_heading}, -360, 360, "", "wanted on arrival"},
      {"tolerance", &l.goal_tolerance, 0.001, 1.0, "m", ""},
      {"heading_tolerance", Angle{&l.heading_tolerance}, 0.01, 180, "", "when a heading is wanted"},
  };
}

Schema schemaOf(ObstacleSpec& o) {
  return {
      {"shape", choice(o.shape, {"disc", "box"}), 0, 0, "", ""},
      {"motion", choice(o.motion, {"fixed", "path", "pushable"}), 0, 0, "", ""},
      {"position", &o.pose.position, -kFarthest, kFarthest, "m", ""},
      {"heading", Heading{&o.pose.heading}, -360, 360, "", ""},
      {"radius", &o.radius, 0.001, 5.0, "m", "of a disc"},
      {"length", &o.length, 0.001, 10.0, "m", "of a box along its x"},
      {"width", &o.width, 0.001, 10.0, "m", "of a box along its y"},
      {"mass", &o.mass, 0.001, 50.0, "kg", "when pushable"},
      {"floor_friction", &o.floor_friction, 0.0, 100.0, "m/s^2", "when pushable"},
      {"path", &o.path, -kFarthest, kFarthest, "m", "waypoints"},
      {"speed", &o.speed, 0.0, 20.0, "m/s", "along the path"},
      {"path_end", choice(o.path_end, {"bounce", "cycle", "stop"}), 0, 0, "", ""},
  };
}

}  // namespace fulbito
