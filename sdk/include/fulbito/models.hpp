// The models of the simulation as numbers: robots, the ball, fields, obstacles, sensors, time steps; and
// their presets and files. Each struct is a plain value; `validate` checks one that a program fills in
// itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A ball on a flat floor. After a kick it slides until its spin catches up, then it rolls and slowly stops.
/// Defaults: the golf ball of the league as measured (docs/models.md).
struct BallModel {
  double radius = 0.0215;   ///< [m]
  double mass = 0.056;      ///< [kg] effective in impacts: the ratio to the robot's mass is measured
  double roll_keep = 0.70;  ///< share of the speed left when sliding becomes rolling (5/7 for a solid ball)
  double slide_deceleration = 3.0;  ///< [m/s^2] while sliding
  double roll_deceleration = 0.14;  ///< [m/s^2] while rolling
  double stop_speed = 0.01;         ///< [m/s] slower rolling balls stop
  double wall_restitution = 0.50;   ///< at a wall, along the normal, before friction changes the spin
  double wall_spin_keep = 0.306;    ///< share of the spin along the normal that survives an impact
  double robot_restitution = 0.04;  ///< against robots and obstacles
  double friction = 0.1;            ///< against everything
};

/// Checks ranges; the error names the key.
Result<void> validate(const BallModel& ball);

/// Differential-drive robot: a rectangular body on two wheels. Motors of limited force make the rim speeds
/// follow the commands. The grip on the floor is limited along and across the wheels. The body couples the
/// wheels: a pull at one affects the other (docs/models.md). Defaults: a 7.5 cm league robot.
struct RobotModel {
  std::string name = "vsss";         ///< name of the preset
  double length = 0.075;             ///< [m] body along x
  double width = 0.075;              ///< [m] body along y
  double mass = 0.15;                ///< [kg]
  double wheel_radius = 0.026;       ///< [m]
  double axle_track = 0.0775;        ///< [m] between wheel centres
  double max_wheel_speed = 46.08;    ///< [rad/s] faster commands are clamped
  double wheel_acceleration = 7.0;   ///< [m/s^2] driving straight, both motors accelerating
  double wheel_braking = 7.0;        ///< [m/s^2] driving straight, both motors braking
  double yaw_acceleration = 0.0;     ///< [rad/s^2] turning in place; 0: from mass and shape
  double rolling_drag = 0.0;         ///< [m/s^2] drag that the motors overcome beyond `wheel_acceleration`
  double longitudinal_grip = 9.0;    ///< [m/s^2] Coulomb limit along the wheels
  double lateral_grip = 6.0;         ///< [m/s^2] Coulomb limit across the wheels
  double spin_slow_speed = 0.0;      ///< [m/s] rim speed of the first measured spin in place; 0: ideal spins
  double spin_slow_ratio = 1.0;      ///< measured over ideal yaw rate at `spin_slow_speed` and below
  double spin_fast_speed = 0.0;      ///< [m/s] rim speed of the second measured spin
  double spin_fast_ratio = 1.0;      ///< the same at `spin_fast_speed` and above; linear between
  double wheel_width = 0.0;          ///< [m] between a wheel's edges, on which it stands
  double support_distance = 0.0;     ///< [m] sliding supports before and behind the axle
  double support_sink = 0.0;         ///< [m] depth by which contacts with the floor give way at rest
  double support_settling = 0.0;     ///< [s] time in which contacts settle to that depth
  double mass_height = 0.0;          ///< [m] centre of mass above the floor; 0: the robot stays level
  double ground_clearance = 0.0;     ///< [m] height of the body's front and rear edge above the floor
  double load_shift = 0.0;           ///< share of a curve's load on the outer wheel that changes the grip
  double rim_mass = 0.0;             ///< [kg] mass at the rim with the inertia of a wheel
  double curve_widening = 0.0;       ///< [s] radius that a curve gains by slip, over the speed; 0: none
  double curve_widening_rise = 0.0;  ///< [s^2/m] by which `curve_widening` rises with the speed
  double friction = 0.2;             ///< of the body against robots, walls and obstacles
  double restitution = 0.1;          ///< of the body against robots, walls and obstacles

  double inertia() const;  ///< [kg m^2] of the body's rectangle about its centre
  /// [m/s^2] Deceleration when both motors brake, within the grip.
  double braking() const;
  double motorPull() const;  ///< [m/s^2] largest force of both motors over the mass, drag compensated
  double turnShare() const;  ///< rim acceleration when turning in place, over `motorPull`
  double turnAcceleration()
      const;  ///< [rad/s^2] turning in place: `yaw_acceleration`, or from mass and shape
  double maxSpeed() const { return max_wheel_speed * wheel_radius; }  ///< [m/s]
  double circumradius() const;                                        ///< [m] of the body's rectangle
};

/// Checks ranges and consistency; the error names the key.
Result<void> validate(const RobotModel& robot);

/// Wheel speeds for the twist, without limits.
WheelSpeeds inverseKinematics(const RobotModel& robot, Twist twist);
/// Twist for the wheel speeds, without slip.
Twist forwardKinematics(const RobotModel& robot, WheelSpeeds wheels);
/// Clamps each wheel to `max_wheel_speed`, without scaling the other; NaN becomes 0.
WheelSpeeds saturate(const RobotModel& robot, WheelSpeeds wheels);
/// Wheel speeds, within limits, for the twist over the ground: where the model slips in curves
/// (`curve_widening`), the wheels turn for a tighter one (Choi & Lee 2005).
WheelSpeeds wheelsOverGround(const RobotModel& robot, Twist twist);
/// Rounds both wheels to multiples of `step` [rad/s]; step <= 0 changes nothing.
WheelSpeeds roundedTo(WheelSpeeds wheels, double step);

/// State of `robot` after one tick of `dt` [s], if its wheels follow `command` by the `DriveLaw` within their
/// grip. Curves are as wide as the model says.
RobotState rolledForward(const RobotModel& model, RobotState robot, WheelSpeeds command, double dt);

/// Time steps and accuracy of the physics. Navigators and teams act once per control tick, which consists of
/// one or more physics steps.
struct PhysicsProfile {
  std::string name = "standard";       ///< name of the preset
  int control_rate = 60;               ///< [Hz] 10 ... 1000
  int substeps = 2;                    ///< physics steps per control tick, 1 ... 64
  int velocity_iterations = 12;        ///< 1 ... 50; with 8, squeezed chains gain energy more often
  int position_iterations = 10;        ///< 1 ... 50; the engine stops early once all errors are small
  bool bullet_ball = true;             ///< continuous collision of the ball against moving bodies too
  double contact_depth = 0.0007;       ///< [m] steps are split so that bodies overlap no deeper; 0: no splits
  double max_ball_speed = 10.0;        ///< [m/s] up to this speed the ball does not tunnel
  double restitution_threshold = 0.1;  ///< [m/s] impacts slower than this do not bounce
  double wheel_command_step = 0.01;    ///< [rad/s] wheel commands are rounded to multiples of this before use

  double controlPeriod() const { return 1.0 / control_rate; }                                 ///< [s]
  double stepPeriod() const { return 1.0 / (static_cast<double>(control_rate) * substeps); }  ///< [s]
};

/// Checks ranges; the error names the key.
Result<void> validate(const PhysicsProfile& physics);

/// The quality of observations of robots and ball: age, noise, gaps. The defaults give the true state.
struct SensorModel {
  int latency_ticks = 0;        ///< age of observations, 0 ... 60
  double position_noise = 0.0;  ///< [m] standard deviation of each coordinate, 0 ... 0.1
  double heading_noise = 0.0;   ///< [rad] standard deviation of headings, 0 ... 2 pi
  double dropout = 0.0;  ///< probability per tick that a body is not seen, 0 ... 0.99; its last state stays

  /// Whether observations are the true state of the present tick.
  bool perfect() const { return *this == SensorModel{}; }
  friend bool operator==(const SensorModel&, const SensorModel&) = default;
};

/// @{ Ends of the ranges of a sensor model.
inline constexpr int kMaxLatencyTicks = 60;
inline constexpr double kMaxPositionNoise = 0.1;         // [m]
inline constexpr double kMaxHeadingNoise = 6.283185307;  // [rad] beyond it a heading has no information
inline constexpr double kMaxDropout = 0.99;
/// @}

/// The heading noise [rad] of a camera that sees positions with `position_noise` [m]. The heading comes from
/// a mark half a `body_length` [m] before the centre, with that noise to the side.
double headingNoise(double position_noise, double body_length);

/// Checks ranges. Errors: kUsage naming the value that is out of its range.
Result<void> validate(const SensorModel& sensors);

/// The content of a robot file: the robot and its ball.
struct RobotPreset {
  RobotModel robot;  ///< table [robot]
  BallModel ball;    ///< table [ball]
};

/// @{ Loads a preset by name or a TOML file by path. A path contains a '/', ends in ".toml", or names an
/// existing file but no preset. Missing keys keep the struct's defaults; a missing `name` becomes the file's.
/// Errors: kUsage for an unknown name (with a suggestion), kIo for an unreadable file, kBadInput as
/// `file:line: table.key ...` with the allowed range.
Result<RobotPreset> loadRobot(const std::string& name_or_file);       ///< tables [robot] and [ball]
Result<PhysicsProfile> loadPhysics(const std::string& name_or_file);  ///< table [physics]
Result<FieldGeometry> loadField(const std::string& name_or_file);     ///< table [field]
/// @}

/// @{ Parses the same tables from text; `origin` stands for the file name in errors.
Result<RobotPreset> parseRobot(std::string_view text, const std::string& origin);
Result<PhysicsProfile> parsePhysics(std::string_view text, const std::string& origin);  ///< table [physics]
Result<FieldGeometry> parseField(std::string_view text, const std::string& origin);     ///< table [field]
/// @}

/// Reads a layout file (format: `parseLayout`). A relative path of a field file starts at the layout's
/// folder; the result has the joined path. The field must load; start, goal and obstacles must lie inside it.
/// Errors: as `loadField`.
Result<Layout> loadLayout(const std::string& file);

/// Parses a layout from text; `origin` stands for the file name in errors. Unlike `loadLayout` it opens no
/// field. Tables: [layout] name, field; [start] position (required), heading; [goal] position (required),
/// heading, tolerance, heading_tolerance; any number of [[obstacle]] with the members of `ObstacleSpec`.
/// Angles: `heading = radians` or `heading_deg = degrees`, not both. Headings are brought into [-pi, pi).
/// An obstacle on a path starts at its first waypoint, so it needs no position. Tables of the named cases,
/// [figure], [[run]] and [sweep], are no part of the layout and stay unread.
Result<Layout> parseLayout(std::string_view text, const std::string& origin);

/// A valid layout as the text of a TOML file that `parseLayout` reads back to the same bits.
std::string toToml(const Layout& layout);
/// @{ All keys with units and meanings, as the text of a TOML file that the loader reads back to the same
/// bits.
std::string toToml(const RobotPreset& preset);
std::string toToml(const PhysicsProfile& physics);  ///< table [physics]
std::string toToml(const FieldGeometry& field);     ///< table [field]
/// @}

/// Names of the presets of one kind ("robots", "physics", "fields").
std::vector<std::string> presetNames(std::string_view kind);
/// The text of a preset. Errors: kUsage, with a suggestion.
Result<std::string> presetText(std::string_view kind, const std::string& name);

}  // namespace fulbito
