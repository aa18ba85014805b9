// A team of your own in C++20: write one class and one macro. This header and `team.h` need nothing else of
// the simulator. `FULBITO_TEAM(MyTeam)` makes a shared library of the class.
//
// Units are SI: m, s, rad, m/s, rad/s. Each team sees its own goal at -x; headings are counter-clockwise, 0
// along +x, in [-pi, pi). The origin is the field's centre.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/team.h"

namespace fulbito::team {

/// Largest number of robots per team.
inline constexpr int kMaxTeamSize = FULBITO_MAX_ROBOTS;

/// Plane vector or point, [m] unless stated otherwise.
struct Vec2 {
  double x = 0.0;  ///< toward the opponents' goal
  double y = 0.0;  ///< to the left, seen from the own goal
  friend constexpr bool operator==(Vec2, Vec2) = default;
};
/// @{ Arithmetic of each component.
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
/// @}
/// Length.
inline double norm(Vec2 a) { return std::sqrt(a.x * a.x + a.y * a.y); }
/// Distance between `a` and `b`.
inline double distance(Vec2 a, Vec2 b) { return norm(a - b); }
/// Direction [rad] of `a`, in [-pi, pi]. Its last bit can differ between machines.
inline double angleOf(Vec2 a) { return std::atan2(a.y, a.x); }  // determinism-ok: a team's own
/// `angle` [rad] modulo 2 pi, in [-pi, pi).
inline double wrapAngle(double angle) {
  constexpr double kPi = 3.14159265358979323846;
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped >= kPi ? wrapped - 2.0 * kPi : wrapped;
}

/// Position and heading.
struct Pose {
  Vec2 position;         ///< [m]
  double heading = 0.0;  ///< [rad]
};

/// Rotation of the two wheels; positive drives forward.
struct Wheels {
  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]
};

/// Motion of a robot in its own frame.
struct Twist {
  double linear = 0.0;   ///< [m/s] forward
  double angular = 0.0;  ///< [rad/s] counter-clockwise
};

/// Colours of the two teams.
enum class Colour : std::uint8_t { kBlue, kYellow };

/// The kinds of restarts.
enum class Restart : std::uint8_t {
  kKickOff,   ///< from the centre
  kFreeBall,  ///< from one of four marks, with a robot of each team next to it
  kFreeKick,  ///< by one team from its mark, after a foul
  kPenalty,   ///< by one team from its mark, against the keeper alone
  kGoalKick,  ///< by one team from its own goal area
  kGiven      ///< from a placement by the user or a drill
};

/// The field: a rectangle with two goals and corner triangles. A size of 0 means that the field lacks it.
struct Field {
  std::string name;                   ///< name of the preset
  double length = 0.0;                ///< [m] x extent
  double width = 0.0;                 ///< [m] y extent
  double goal_width = 0.0;            ///< [m] y extent of the goal's mouth
  double goal_depth = 0.0;            ///< [m] behind the goal line
  double corner = 0.0;                ///< [m] legs of the corner triangles
  double wall_thickness = 0.0;        ///< [m]
  double goal_area_width = 0.0;       ///< [m] y extent
  double goal_area_depth = 0.0;       ///< [m] x extent
  double goal_area_arc_width = 0.0;   ///< [m] chord of the arc in front of the goal area
  double goal_area_arc_depth = 0.0;   ///< [m] depth of the arc beyond the area's front line
  double big_area_width = 0.0;        ///< [m] y extent of the larger games' penalty area
  double big_area_depth = 0.0;        ///< [m] its x extent
  double centre_circle_radius = 0.0;  ///< [m]
  double penalty_mark = 0.0;          ///< [m] distance from the centre along x
  Vec2 free_ball_mark;                ///< [m] in the first quadrant; the other three are mirrored
};

/// The robots of both teams: a rectangle on two wheels.
struct RobotModel {
  std::string name;                 ///< name of the preset
  double length = 0.0;              ///< [m] body along its front
  double width = 0.0;               ///< [m] body across
  double mass = 0.0;                ///< [kg]
  double wheel_radius = 0.0;        ///< [m]
  double axle_track = 0.0;          ///< [m] between wheel centres
  double max_wheel_speed = 0.0;     ///< [rad/s] faster commands are clamped
  double wheel_acceleration = 0.0;  ///< [m/s^2] driving straight
  double wheel_braking = 0.0;       ///< [m/s^2] driving straight
  double yaw_acceleration = 0.0;    ///< [rad/s^2] turning in place; 0: from mass and shape
  double rolling_drag = 0.0;        ///< [m/s^2] drag that the motors overcome beyond `wheel_acceleration`
  double longitudinal_grip = 0.0;   ///< [m/s^2] limit along the wheels
  double lateral_grip = 0.0;        ///< [m/s^2] limit across the wheels
  double spin_slow_speed = 0.0;     ///< [m/s] rim speed of the first measured spin in place; 0: ideal spins
  double spin_slow_ratio = 0.0;     ///< measured over ideal yaw rate at `spin_slow_speed` and below
  double spin_fast_speed = 0.0;     ///< [m/s] rim speed of the second measured spin
  double spin_fast_ratio = 0.0;     ///< the same at `spin_fast_speed` and above; linear between
  double friction = 0.0;            ///< of the body
  double restitution = 0.0;         ///< of the body
  /// [s] Radius that a curve gains by slip, over the speed; 0: none.
  double curve_widening = 0.0;
  /// [s^2/m] By which `curve_widening` rises with the speed.
  double curve_widening_rise = 0.0;

  /// [m/s] Largest speed straight ahead.
  double maxSpeed() const { return max_wheel_speed * wheel_radius; }
  /// [m] Half the diagonal of the body.
  double circumradius() const { return std::sqrt(length * length + width * width) / 2.0; }
};

/// The ball. After a kick it slides; then it rolls and slowly stops.
struct BallModel {
  double radius = 0.0;              ///< [m]
  double mass = 0.0;                ///< [kg]
  double roll_keep = 0.0;           ///< share of the speed left when sliding becomes rolling
  double slide_deceleration = 0.0;  ///< [m/s^2] while sliding
  double roll_deceleration = 0.0;   ///< [m/s^2] while rolling
  double stop_speed = 0.0;          ///< [m/s] slower rolling balls stop
  double wall_restitution = 0.0;    ///< at a wall, along the normal
  double wall_spin_keep = 0.0;      ///< share of the spin along the normal that survives an impact
  double robot_restitution = 0.0;   ///< against robots
  double friction = 0.0;            ///< against everything
};

/// Time steps and accuracy of the physics.
struct Physics {
  std::string name;                    ///< name of the preset
  int control_rate = 60;               ///< [Hz] decisions per second
  int substeps = 1;                    ///< physics steps per decision
  int velocity_iterations = 0;         ///< of the engine
  int position_iterations = 0;         ///< of the engine
  bool bullet_ball = false;            ///< continuous collision of the ball against moving bodies
  double contact_depth = 0.0;          ///< [m] deepest overlap before a step is split; 0: no splits
  double max_ball_speed = 0.0;         ///< [m/s] up to this speed the ball does not tunnel
  double restitution_threshold = 0.0;  ///< [m/s] slower impacts do not bounce
  double wheel_command_step = 0.0;     ///< [rad/s] wheel commands are rounded to multiples of this
};

/// The tie-break after two halves.
enum class TieBreak : std::uint8_t { kNone, kOvertime, kShootOut, kBoth };

/// The rules as values that teams need. `text` has all of them.
struct Rules {
  std::string name;                      ///< name of the preset
  int team_size = 3;                     ///< robots per team
  double half_seconds = 0.0;             ///< [s] play time of a half
  bool swap_sides = false;               ///< teams change sides at half-time; observations stay mirrored
  int mercy_goals = 0;                   ///< lead that ends the match; 0: never
  TieBreak tie_break = TieBreak::kNone;  ///< after two halves
  int overtime_parts = 0;                ///< periods of overtime
  double overtime_seconds = 0.0;         ///< [s] play time of each
  bool golden_goal = false;              ///< the first goal in overtime ends the match
  double kick_seconds = 0.0;             ///< [s] time limit of a kick in a shoot-out
  double restart_delay = 0.0;            ///< [s] from the placement to the signal
  double goal_delay = 0.0;               ///< [s] the same after a goal
  bool hold_robots = false;              ///< robots cannot move before the signal
  double false_start_distance = 0.0;     ///< [m] a robot this far from its place before the signal has moved
  double free_ball_distance = 0.0;       ///< [m] least distance from the ball at a free ball
  bool goal_kick_ball_free = false;      ///< the taker may place the ball anywhere in its goal area
  double stuck_seconds = 0.0;            ///< [s] a ball at rest this long is stuck, outside the goal areas
  double stuck_area_seconds = 0.0;       ///< [s] the same in a goal area
  double stuck_radius = 0.0;             ///< [m] leaving this circle restarts the count
  bool areas_have_arc = false;           ///< the goal area includes its arc
  int attackers_max = 0;                 ///< robots allowed in the opponents' goal area; negative: any number
  int big_attackers_max = 0;             ///< robots allowed in the opponents' big area; negative: any number
  int defenders_max = 0;      ///< robots allowed in the own goal area with the ball; negative: any number
  int big_defenders_max = 0;  ///< robots allowed in the own big area; negative: any number
  double keeper_hold_seconds = 0.0;  ///< [s] longest undisputed control by the keeper; 0: no limit
  bool keeper_charging = false;      ///< charging the keeper is a foul
  bool pushing = false;              ///< pushing away from the ball is a foul
  bool pinning = false;              ///< pinning the ball to a wall is a foul
  double pinned_seconds = 0.0;       ///< [s] longest time for that
  std::string text;                  ///< all rules, with units and meanings, as TOML
};

/// Limits of the decision time, in wall time.
struct DecisionTime {
  double decision = 0.0;  ///< [s] limit of each decision
  double bank = 0.0;      ///< [s] total time beyond it per period
  int held = 0;           ///< late decisions in a row for which the last command stays in force
};

/// A team's knowledge before the match.
struct Info {
  Colour colour = Colour::kBlue;              ///< the team's colour
  bool left = true;                           ///< the team defends the left goal of pictures at first
  Field field;                                ///< field of the match
  RobotModel robot;                           ///< robots of both teams
  BallModel ball;                             ///< ball of the match
  Physics physics;                            ///< time steps
  Rules rules;                                ///< team size, length of the periods, limits of the calls
  double dt = 1.0 / 60.0;                     ///< [s] control period: one decision per period
  double observation_age = 0.0;               ///< [s] nominal age of each observation
  double position_noise = 0.0;                ///< [m] standard deviation of observed positions
  double heading_noise = 0.0;                 ///< [rad] standard deviation of observed headings
  double dropout = 0.0;                       ///< probability per tick that a body is not seen
  std::optional<DecisionTime> decision_time;  ///< limit of the decision time; empty: unlimited
  std::uint64_t seed = 0;                     ///< of the team's random stream (`Team::random`)
};

/// A robot as the team sees it.
struct Robot {
  bool present = false;           ///< false: not on the field; all other members are 0
  Vec2 position;                  ///< [m]
  double heading = 0.0;           ///< [rad]
  Vec2 velocity;                  ///< [m/s]
  double angular_velocity = 0.0;  ///< [rad/s]
  Wheels wheels;                  ///< [rad/s] of own robots; 0 for opponents
};

/// The ball as the team sees it.
struct Ball {
  Vec2 position;  ///< [m]
  Vec2 velocity;  ///< [m/s]
};

/// A team's knowledge at one control tick.
struct Observation {
  std::int64_t tick = 0;                      ///< tick of the match that it shows
  double dt = 1.0 / 60.0;                     ///< [s] control period
  int team_size = 3;                          ///< robots per team, present or not
  std::array<Robot, kMaxTeamSize> own;        ///< the team's robots, by number
  std::array<Robot, kMaxTeamSize> opponents;  ///< the other team's robots, by number
  Ball ball;                                  ///< the ball
  std::array<Wheels, kMaxTeamSize> sent;      ///< [rad/s] applied to the team's robots in the previous tick
  bool playing = true;                        ///< false while a restart waits for its signal
  Restart restart = Restart::kKickOff;        ///< the restart that began the present play
  bool restart_is_ours = false;               ///< the team takes it (a free ball: it attacks that half)
  double since_restart = 0.0;                 ///< [s] of play since the signal; negative before it
  int period = 1;                             ///< 1, 2: halves; 3: overtime; 4: shoot-out
  double remaining = 0.0;                     ///< [s] of play left in the period
  int own_score = 0;                          ///< goals of the team
  int opponent_score = 0;                     ///< goals against it
  bool wants_drawings = false;                ///< an observer keeps the drawings of this tick
};

/// A place to drive to. The simulator's navigator plans the path among the other robots.
struct GoTo {
  Vec2 position;                  ///< [m] target of the robot's centre
  std::optional<double> heading;  ///< [rad] on arrival; empty: any
  bool stop = false;              ///< stop at the target; otherwise pass it at speed
  double speed_limit = std::numeric_limits<double>::infinity();  ///< [m/s] largest speed
  bool avoid_ball = false;                                       ///< the ball is an obstacle too
  bool avoid_mates = true;                                       ///< the team's own robots are obstacles
  bool avoid_opponents = true;                                   ///< the opponents are obstacles
  double tolerance = 0.03;                                       ///< [m] distance that counts as arrival
  bool either_front = true;  ///< either end may lead; false: the front leads
  int navigator = 0;         ///< index in `Team::navigators`
};

/// One robot's command until the next decision.
struct Command {
  /// The form of a command.
  enum class Kind : std::uint8_t { kWheels, kTwist, kGoTo };
  Kind kind = Kind::kWheels;  ///< selects one of the members below
  Wheels wheels;              ///< for kWheels: as given
  Twist twist;                ///< for kTwist: limited so that the robot can always steer
  GoTo go_to;                 ///< for kGoTo: by a navigator
};

/// A drawing of a team's intentions for viewers.
struct Drawing {
  /// The kinds of drawings.
  enum class Kind : std::uint8_t { kLine, kCircle, kText };
  Kind kind = Kind::kLine;  ///< line, circle or text
  Vec2 from;                ///< [m] start of a line; centre of a circle or a text
  Vec2 to;                  ///< [m] end of a line
  double radius = 0.0;      ///< [m] of a circle
  std::string text;         ///< for kText
};

/// A team's decision for one tick. Robots without a command stand still.
struct Commands {
  std::array<Command, kMaxTeamSize> robots;        ///< by robot number
  std::array<std::uint8_t, kMaxTeamSize> roles{};  ///< a number per role from 1; 0: unknown
  std::vector<Drawing> drawings;                   ///< empty unless `Observation::wants_drawings`

  /// @{ Commands robot `i`; numbers out of 0 ... kMaxTeamSize - 1 throw std::out_of_range.
  void wheels(int i, double left, double right) { at(i) = {Command::Kind::kWheels, {left, right}, {}, {}}; }
  void twist(int i, double linear, double angular) {
    at(i) = {Command::Kind::kTwist, {}, {linear, angular}, {}};
  }
  void goTo(int i, const GoTo& target) { at(i) = {Command::Kind::kGoTo, {}, {}, target}; }
  /// @}
  /// @{ Draws for viewers.
  void line(Vec2 from, Vec2 to) { drawings.push_back({Drawing::Kind::kLine, from, to, 0.0, {}}); }
  void circle(Vec2 centre, double radius) {
    drawings.push_back({Drawing::Kind::kCircle, centre, {}, radius, {}});
  }
  void text(Vec2 place, std::string words) {
    drawings.push_back({Drawing::Kind::kText, place, {}, 0.0, std::move(words)});
  }
  /// @}

 private:
  Command& at(int i) { return robots.at(static_cast<std::size_t>(i)); }
};

/// A call of the referee, with its measured value.
struct Call {
  std::int64_t tick = 0;       ///< tick of the match
  double play_time = 0.0;      ///< [s] play time in the period
  int period = 1;              ///< 1, 2: halves; 3: overtime; 4: shoot-out
  std::string clause;          ///< name of the rule, e.g. "goal-kick.attackers"; empty: no call
  std::string law;             ///< section of the rule book, e.g. "8.2"
  std::optional<Colour> team;  ///< team that the call is against; for a goal, the scoring team
  std::optional<int> robot;    ///< the robot at fault or the scorer, if known
  Vec2 place;                  ///< [m] the ball's position
  double value = 0.0;          ///< measured value, in the unit of the threshold
  double threshold = 0.0;      ///< limit of the rule
  double margin = 0.0;         ///< distance of the value from the limit; positive
};

/// Poses by robot number; empty: no wish, or not on the field.
using Poses = std::array<std::optional<Pose>, kMaxTeamSize>;

/// The request for a team's placement at a restart.
struct PlacementRequest {
  Restart kind = Restart::kKickOff;  ///< the kind of restart
  bool ours = false;                 ///< the team takes the restart
  Vec2 ball;                         ///< [m] ball position; for the other team, after the taker's choice
  Poses defaults;                    ///< placement by the rules
  std::optional<Poses> opponents;    ///< the other team's placement, if the rule lets it place first
  Call cause;                        ///< the call that stopped play
  double delay = 0.0;                ///< [s] from the placement to the signal; 0: play begins at once
  Observation now;                   ///< score, time and all poses when play stopped
};

/// A team's wishes at a restart. The referee repairs poses that are not allowed.
struct Placement {
  Poses robots;              ///< by robot number; empty: the place by the rules
  std::optional<Vec2> ball;  ///< [m] for the team's own goal kick, if the rules leave it free
};

/// The notice that play is stopped.
struct Stop {
  Call cause;       ///< the call
  Observation now;  ///< with the score after the call
};

/// The notice that the match is over.
struct End {
  /// Why a match ends.
  enum class Reason : std::uint8_t {
    kPlayed,       ///< its regular end by the rules
    kAbandoned,    ///< the state of a restart was not valid
    kInterrupted,  ///< the user ended it
  };
  Reason reason = Reason::kPlayed;  ///< why this match ends
  Call cause;                       ///< the call that ended it; empty if interrupted
  std::int64_t tick = 0;            ///< last tick of the match
  int own_score = 0;                ///< goals of the team
  int opponent_score = 0;           ///< goals against it
  std::optional<Colour> winner;     ///< empty after a draw or an unfinished match
};

/// A task of a drill: one skill of the team's first robot instead of a whole match.
struct Exercise {
  /// The kinds of tasks.
  enum class Kind : std::uint8_t {
    kReachPose,    ///< stop at `target` with `heading`
    kTurn,         ///< turn to `heading` in place
    kReachBall,    ///< be behind the resting ball at `heading`, moving on through it at `speed`
    kPush,         ///< push the ball along `heading` at `speed`
    kPredictBall,  ///< predict the ball's position `horizon` seconds from now
  };
  Kind kind = Kind::kReachPose;  ///< selects the members below
  Vec2 target;                   ///< [m] for kReachPose
  double heading = 0.0;          ///< [rad]
  double speed = 0.0;            ///< [m/s]
  double horizon = 0.0;          ///< [s] for kPredictBall
};

/// A team's reply in an exercise.
struct ExerciseReply {
  Commands commands;  ///< command of its first robot
  Vec2 answer;        ///< [m] predicted ball position, for kPredictBall
};

/// Random numbers from a seed: the same on every machine and compiler (SplitMix64; Steele, Lea, Flood,
/// OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed = 0) : state_(seed) {}
  /// 64 random bits.
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In 0 ... n - 1; 0 if n < 2. The bias is below n / 2^64.
  std::uint64_t below(std::uint64_t n) { return n < 2 ? 0 : bits() % n; }

 private:
  std::uint64_t state_;
};

/// A documented parameter of a team, which specifications set: `./mine.so:aggression=0.7`.
struct Parameter {
  /// The types of values.
  enum class Type : std::uint8_t { kNumber, kInteger, kFlag, kChoice };
  std::string name;                  ///< as in `name=value`
  Type type = Type::kNumber;         ///< type of its values
  double default_value = 0.0;        ///< of a flag: 0 or 1; of a choice: its index
  double minimum = 0.0;              ///< least allowed value
  double maximum = 0.0;              ///< largest allowed value
  std::vector<std::string> choices;  ///< for kChoice: the names of its values
  std::string unit;                  ///< e.g. "m/s"; empty: none
  std::string doc;                   ///< one line for people
  std::function<void(double)> set;   ///< takes a checked value; of a choice: its index
};

/// What teams and navigators have in common: their description, their parameters, and a way to say something.
class Described {
 public:
  virtual ~Described() = default;
  Described(const Described&) = delete;
  Described& operator=(const Described&) = delete;

  /// @{ For runners (the macros at the end and programs); an author needs none of them.
  const std::string& name() const { return name_; }
  const std::string& summary() const { return summary_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  /// The function that receives the lines of `log`.
  void logTo(std::function<void(std::string_view)> sink) { sink_ = std::move(sink); }
  /// @}

 protected:
  Described(std::string name, std::string summary) : name_(std::move(name)), summary_(std::move(summary)) {}

  /// @{ Parameters, declared in the constructor: `number("aggression", aggression_, 0, 1, "", "how ...")`.
  /// The member's present value is the default. `value` must live as long as the object: a member of its
  /// class.
  void number(std::string name, double& value, double minimum, double maximum, std::string unit,
              std::string doc) {
    parameters_.push_back({std::move(name),
                           Parameter::Type::kNumber,
                           value,
                           minimum,
                           maximum,
                           {},
                           std::move(unit),
                           std::move(doc),
                           [&value](double v) { value = v; }});
  }
  void integer(std::string name, int& value, int minimum, int maximum, std::string unit, std::string doc) {
    parameters_.push_back({std::move(name),
                           Parameter::Type::kInteger,
                           static_cast<double>(value),
                           static_cast<double>(minimum),
                           static_cast<double>(maximum),
                           {},
                           std::move(unit),
                           std::move(doc),
                           [&value](double v) { value = static_cast<int>(v); }});
  }
  void flag(std::string name, bool& value, std::string doc) {
    parameters_.push_back({std::move(name),
                           Parameter::Type::kFlag,
                           value ? 1.0 : 0.0,
                           0.0,
                           1.0,
                           {},
                           {},
                           std::move(doc),
                           [&value](double v) { value = v != 0.0; }});
  }
  /// `value` is the index of the choice.
  void choice(std::string name, int& value, std::vector<std::string> choices, std::string doc) {
    const double last = static_cast<double>(choices.size()) - 1.0;
    parameters_.push_back({std::move(name),
                           Parameter::Type::kChoice,
                           static_cast<double>(value),
                           0.0,
                           last,
                           std::move(choices),
                           {},
                           std::move(doc),
                           [&value](double v) { value = static_cast<int>(v); }});
  }
  /// @}
  /// Says something to the user; without a runner, on standard error.
  void log(std::string_view line) const {  // determinism-ok: a message
    if (sink_) {
      sink_(line);
    } else {
      std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
    }
  }

 private:
  std::string name_, summary_;
  std::vector<Parameter> parameters_;
  std::function<void(std::string_view)> sink_;
};

/// A team. The simulator calls `begin` first and `ended` last. For each play it calls `place`, `ready`,
/// `decide` once per tick, and `stopped`. Calls of one instance never overlap; two instances may run at the
/// same time. Exceptions are caught and reported, and count as a crash of the team.
///
/// For the same observations, give the same commands: use `random`, no clock, and no other source of chance.
class Team : public Described {
 public:
  /// Describes the team: a name for tables, its version, and one line about it.
  explicit Team(std::string name, std::string version = "", std::string summary = "")
      : Described(std::move(name), std::move(summary)), version_(std::move(version)) {}

  /// A new match begins: reset all memory. `info()` and `random()` are ready.
  virtual void begin(const Info&) {}
  /// The decision for one control tick; called once per tick. Read no clock and allocate nothing once warm.
  virtual Commands decide(const Observation& observation) = 0;
  /// Specifications of the simulator's navigators that `GoTo::navigator` indexes, e.g. "bezier". Called after
  /// `begin`. The default: the one that `takesNavigator` asks for.
  virtual std::vector<std::string> navigators() {
    return navigator_.empty() ? std::vector<std::string>{} : std::vector<std::string>{navigator_};
  }
  /// The team's placement at a restart; empty: no wishes.
  virtual std::optional<Placement> place(const PlacementRequest&) { return std::nullopt; }
  /// Play is stopped. Called before the placement requests of the restart.
  virtual void stopped(const Stop&) {}
  /// The new play is placed. Called before its first decision, with exact poses.
  virtual void ready(const Observation&) {}
  /// The match is over; no call follows.
  virtual void ended(const End&) {}
  /// One tick of an exercise; empty if the team lacks the skill.
  virtual std::optional<ExerciseReply> exercise(const Observation&, const Exercise&) { return std::nullopt; }

  /// @{ For runners (`FULBITO_TEAM` and programs); a team's author needs none of them.
  const std::string& version() const { return version_; }
  /// Default of the setting `navigator`; empty: the team takes none.
  const std::string& defaultNavigator() const { return default_navigator_; }
  /// Takes the setting `name=value`. @return what is wrong with it; empty: it is taken
  std::string set(std::string_view name, std::string_view value);
  /// Keeps `info`, seeds the random stream, then calls `begin`.
  void start(const Info& info) {
    info_ = info;
    random_ = Random(info.seed);
    begin(info_);
  }
  /// @}

 protected:
  /// The team takes the setting `navigator=NAME`, with this default.
  void takesNavigator(std::string by_default) {
    default_navigator_ = std::move(by_default);
    navigator_ = default_navigator_;
  }
  /// What the team knows since `begin`.
  const Info& info() const { return info_; }
  /// The team's random stream: the same numbers in each match with the same seed.
  Random& random() { return random_; }  // determinism-ok: seeded

 private:
  std::string version_;
  std::string default_navigator_, navigator_;
  Info info_;
  Random random_;
};

/// A round obstacle for a navigator. Discs also cover the boxes.
struct Disc {
  Vec2 position;        ///< [m] its centre now
  Vec2 velocity;        ///< [m/s]
  double radius = 0.0;  ///< [m] the obstacle's own radius, not inflated by the robot
};

/// A navigator's knowledge at one control tick.
struct NavigationScene {
  std::int64_t tick = 0;               ///< counts control ticks; never goes back within a trial
  double dt = 1.0 / 60.0;              ///< [s] control period
  Robot self;                          ///< the robot
  Vec2 goal;                           ///< [m] target of the robot's centre
  std::optional<double> goal_heading;  ///< [rad] on arrival; empty: any
  double tolerance = 0.0;              ///< [m] distance that counts as arrival
  double heading_tolerance = 0.0;      ///< [rad] difference that counts as the wanted heading
  bool stop = false;                   ///< stop at the goal; otherwise the robot may pass it at speed
  std::vector<Disc> obstacles;         ///< the other bodies, in any order
  Field field;                         ///< its size
  RobotModel robot;                    ///< its max_wheel_speed is the speed limit of this trial
};

/// A navigator's output. All numbers are finite, except `speed_cap`.
struct Guidance {
  /// The forms of guidance.
  enum class Kind : std::uint8_t { kField, kPath, kTimedPath, kWheels };
  Kind kind = Kind::kWheels;
  std::vector<Vec2> path;      ///< [m] for both kinds of paths: from robot to goal, at least 2 points
  std::vector<double> speeds;  ///< [m/s] for kTimedPath: speed at each point of the path
  std::uint64_t revision = 0;  ///< changes whenever `path` or `speeds` do
  Wheels wheels;               ///< [rad/s] for kWheels
  double speed_cap = std::numeric_limits<double>::infinity();  ///< [m/s] present speed limit
};

/// One navigation method. An instance belongs to one robot and keeps its memory between ticks. Exceptions are
/// caught and reported, and stop the robot.
class Navigator : public Described {
 public:
  /// Describes the method: its name in specifications, one line about it, and where it is from.
  /// @param plans_speed  it gives its own speeds or wheel speeds; tables mark it
  explicit Navigator(std::string name, std::string summary = "", std::string source = "",
                     bool plans_speed = false)
      : Described(std::move(name), std::move(summary)),
        source_(std::move(source)),
        plans_speed_(plans_speed) {}

  /// Resets all memory: the next call starts a new trial.
  virtual void reset() {}
  /// Plans the motion in the present scene; called once per control tick. Read no clock and allocate nothing
  /// once warm. `guidance` keeps its memory between the calls; its `speed_cap` is preset to infinity.
  virtual void plan(const NavigationScene& scene, Guidance& guidance) = 0;
  /// Direction of travel [rad] at a point, after `plan` gave kField. Called many times per tick.
  virtual double heading(Vec2) const { return 0.0; }

  /// @{ For runners.
  const std::string& source() const { return source_; }
  bool plansSpeed() const { return plans_speed_; }
  /// @}

 private:
  std::string source_;
  bool plans_speed_;
};

namespace detail {

/// Value of a flag's text: "true", "on", "1" or their opposites; empty: neither.
inline std::optional<double> flagValue(std::string_view text) {
  if (text == "true" || text == "on" || text == "1") return 1.0;
  if (text == "false" || text == "off" || text == "0") return 0.0;
  return std::nullopt;
}

/// Value of `text` for `parameter`; empty: not one of its values.
inline std::optional<double> valueOf(const Parameter& parameter, std::string_view text) {
  if (parameter.type == Parameter::Type::kFlag) return flagValue(text);
  if (parameter.type == Parameter::Type::kChoice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found == parameter.choices.end()) return std::nullopt;
    return static_cast<double>(found - parameter.choices.begin());
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = parameter.type != Parameter::Type::kInteger || value == std::floor(value);
  const bool inside = value >= parameter.minimum && value <= parameter.maximum;
  if (code != std::errc{} || end != text.data() + text.size() || !whole || !inside) return std::nullopt;
  return value;
}

/// A number as short text.
inline std::string shortText(double value) {
  char text[32];
  const auto [end, code] = std::to_chars(text, text + sizeof text, value);
  return {text, end};
}

/// The values that `parameter` takes, in words.
inline std::string rangeOf(const Parameter& parameter) {
  if (parameter.type == Parameter::Type::kFlag) return "true or false";
  if (parameter.type == Parameter::Type::kChoice) {
    std::string names;
    for (const std::string& name : parameter.choices) names += (names.empty() ? "" : ", ") + name;
    return "one of " + names;
  }
  return (parameter.type == Parameter::Type::kInteger ? "a whole number from " : "a number from ") +
         shortText(parameter.minimum) + " to " + shortText(parameter.maximum) +
         (parameter.unit.empty() ? "" : " " + parameter.unit);
}

}  // namespace detail

inline std::string Team::set(std::string_view name, std::string_view value) {
  if (name == "navigator" && !default_navigator_.empty()) {
    navigator_ = value;
    return {};
  }
  for (const Parameter& parameter : parameters()) {
    if (parameter.name != name) continue;
    const auto number = detail::valueOf(parameter, value);
    if (!number) {
      return "parameter '" + parameter.name + "': '" + std::string(value) + "' is not " +
             detail::rangeOf(parameter);
    }
    parameter.set(*number);
    return {};
  }
  return "'" + this->name() + "' has no parameter '" + std::string(name) + "'";
}

// The rest joins the class to the C interface; a team's author needs only the macro at the end. It is hidden:
// otherwise two libraries with a class of the same name would share the static variables below.
#pragma GCC visibility push(hidden)
namespace detail {

/// @{ From the C interface.
inline Vec2 from(fulbito_vec2 v) { return {v.x, v.y}; }
inline Wheels from(fulbito_wheels w) { return {w.left, w.right}; }
inline Pose from(const fulbito_pose& p) { return {from(p.position), p.heading}; }

inline std::optional<Colour> colourOf(int number) {
  if (number != FULBITO_BLUE && number != FULBITO_YELLOW) return std::nullopt;
  return number == FULBITO_BLUE ? Colour::kBlue : Colour::kYellow;
}

inline Field from(const fulbito_field& f) {
  return {f.name,
          f.length,
          f.width,
          f.goal_width,
          f.goal_depth,
          f.corner,
          f.wall_thickness,
          f.goal_area_width,
          f.goal_area_depth,
          f.goal_area_arc_width,
          f.goal_area_arc_depth,
          f.big_area_width,
          f.big_area_depth,
          f.centre_circle_radius,
          f.penalty_mark,
          from(f.free_ball_mark)};
}

inline RobotModel from(const fulbito_robot_model& r) {
  return {r.name,
          r.length,
          r.width,
          r.mass,
          r.wheel_radius,
          r.axle_track,
          r.max_wheel_speed,
          r.wheel_acceleration,
          r.wheel_braking,
          r.yaw_acceleration,
          r.rolling_drag,
          r.longitudinal_grip,
          r.lateral_grip,
          r.spin_slow_speed,
          r.spin_slow_ratio,
          r.spin_fast_speed,
          r.spin_fast_ratio,
          r.friction,
          r.restitution};
}

/// The part of the model that the host gives as an extension. A simulator before it gives none.
inline void takeCurveWidening(const fulbito_host& host, RobotModel& robot) {
  const void* found = host.get_extension(&host, FULBITO_EXT_CURVE_WIDENING);
  if (found == nullptr) return;
  const auto& widening = *static_cast<const fulbito_curve_widening*>(found);
  robot.curve_widening = widening.curve_widening;
  robot.curve_widening_rise = widening.curve_widening_rise;
}

inline BallModel from(const fulbito_ball_model& b) {
  return {b.radius,
          b.mass,
          b.roll_keep,
          b.slide_deceleration,
          b.roll_deceleration,
          b.stop_speed,
          b.wall_restitution,
          b.wall_spin_keep,
          b.robot_restitution,
          b.friction};
}

inline Physics from(const fulbito_physics& p) {
  return {p.name,
          p.control_rate,
          p.substeps,
          p.velocity_iterations,
          p.position_iterations,
          p.bullet_ball != 0,
          p.contact_depth,
          p.max_ball_speed,
          p.restitution_threshold,
          p.wheel_command_step};
}

inline Rules from(const fulbito_rules& r) {
  Rules to;
  to.name = r.name;
  to.team_size = r.team_size;
  to.half_seconds = r.half_seconds;
  to.swap_sides = r.swap_sides != 0;
  to.mercy_goals = r.mercy_goals;
  to.tie_break = static_cast<TieBreak>(r.tie_break);
  to.overtime_parts = r.overtime_parts;
  to.overtime_seconds = r.overtime_seconds;
  to.golden_goal = r.golden_goal != 0;
  to.kick_seconds = r.kick_seconds;
  to.restart_delay = r.restart_delay;
  to.goal_delay = r.goal_delay;
  to.hold_robots = r.hold_robots != 0;
  to.false_start_distance = r.false_start_distance;
  to.free_ball_distance = r.free_ball_distance;
  to.goal_kick_ball_free = r.goal_kick_ball_free != 0;
  to.stuck_seconds = r.stuck_seconds;
  to.stuck_area_seconds = r.stuck_area_seconds;
  to.stuck_radius = r.stuck_radius;
  to.areas_have_arc = r.areas_have_arc != 0;
  to.attackers_max = r.attackers_max;
  to.big_attackers_max = r.big_attackers_max;
  to.defenders_max = r.defenders_max;
  to.big_defenders_max = r.big_defenders_max;
  to.keeper_hold_seconds = r.keeper_hold_seconds;
  to.keeper_charging = r.keeper_charging != 0;
  to.pushing = r.pushing != 0;
  to.pinning = r.pinning != 0;
  to.pinned_seconds = r.pinned_seconds;
  return to;
}

inline Info from(const fulbito_match_info& i) {
  Info to;
  to.colour = i.colour == FULBITO_BLUE ? Colour::kBlue : Colour::kYellow;
  to.left = i.left != 0;
  to.field = from(i.field);
  to.robot = from(i.robot);
  to.ball = from(i.ball);
  to.physics = from(i.physics);
  to.rules = from(i.rules);
  to.dt = i.dt;
  to.observation_age = i.observation_age;
  to.position_noise = i.position_noise;
  to.heading_noise = i.heading_noise;
  to.dropout = i.dropout;
  if (std::isfinite(i.decision_seconds)) {
    to.decision_time = DecisionTime{i.decision_seconds, i.decision_bank, i.decisions_held};
  }
  to.seed = i.seed;
  return to;
}

inline Robot from(const fulbito_robot& r) {
  return {r.present != 0, from(r.position), r.heading, from(r.velocity), r.angular_velocity, from(r.wheels)};
}

inline void take(const fulbito_observation& o, Observation& to) {
  to.tick = o.tick;
  to.dt = o.dt;
  to.team_size = o.team_size;
  for (std::size_t i = 0; i < static_cast<std::size_t>(o.team_size); ++i) {
    to.own[i] = from(o.own[i]);
    to.opponents[i] = from(o.opponents[i]);
    to.sent[i] = from(o.sent[i]);
  }
  to.ball = {from(o.ball.position), from(o.ball.velocity)};
  to.playing = o.playing != 0;
  to.restart = static_cast<Restart>(o.restart);
  to.restart_is_ours = o.restart_is_ours != 0;
  to.since_restart = o.since_restart;
  to.period = o.period;
  to.remaining = o.remaining;
  to.own_score = o.own_score;
  to.opponent_score = o.opponent_score;
  to.wants_drawings = o.wants_drawings != 0;
}

inline Observation from(const fulbito_observation& o) {
  Observation to;
  take(o, to);
  return to;
}

inline Call from(const fulbito_call& c) {
  Call to;
  to.tick = c.tick;
  to.play_time = c.play_time;
  to.period = c.period;
  to.clause = c.clause;
  to.law = c.law;
  to.team = colourOf(c.team);
  if (c.robot >= 0) to.robot = c.robot;
  to.place = from(c.place);
  to.value = c.value;
  to.threshold = c.threshold;
  to.margin = c.margin;
  return to;
}

inline Poses from(const fulbito_poses& p) {
  Poses to;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (p.present[i] != 0) to[i] = from(p.pose[i]);
  }
  return to;
}

inline PlacementRequest from(const fulbito_placement_request& r) {
  PlacementRequest to;
  to.kind = static_cast<Restart>(r.kind);
  to.ours = r.ours != 0;
  to.ball = from(r.ball);
  to.defaults = from(r.defaults);
  if (r.has_opponents != 0) to.opponents = from(r.opponents);
  to.cause = from(r.cause);
  to.delay = r.delay;
  to.now = from(r.now);
  return to;
}

inline End from(const fulbito_end& e) {
  return {static_cast<End::Reason>(e.reason),
          from(e.cause),
          e.tick,
          e.own_score,
          e.opponent_score,
          colourOf(e.winner)};
}

inline Exercise from(const fulbito_exercise& e) {
  return {static_cast<Exercise::Kind>(e.kind), from(e.target), e.heading, e.speed, e.horizon};
}
/// @}

/// @{ To the C interface.
inline fulbito_vec2 to(Vec2 v) { return {v.x, v.y}; }
inline fulbito_pose to(const Pose& p) { return {to(p.position), p.heading}; }

inline fulbito_go_to to(const GoTo& g) {
  // An index that the interface cannot carry is unknown there too.
  const bool known = g.navigator >= 0 && g.navigator < 255;
  return {to(g.position),
          g.heading.value_or(0.0),
          g.speed_limit,
          g.tolerance,
          g.heading.has_value(),
          g.stop,
          g.avoid_ball,
          g.avoid_mates,
          g.avoid_opponents,
          g.either_front,
          static_cast<std::uint8_t>(known ? g.navigator : 255),
          0};
}

inline fulbito_drawing to(const Drawing& d) {
  fulbito_drawing c{static_cast<std::uint32_t>(d.kind), 0, to(d.from), to(d.to), d.radius, {}};
  std::memcpy(c.text, d.text.data(), std::min<std::size_t>(d.text.size(), FULBITO_NAME_SIZE - 1));
  return c;
}

inline void give(const Commands& commands, int team_size, fulbito_team_command& out) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
    const Command& c = commands.robots[i];
    out.robots[i] = {static_cast<std::uint32_t>(c.kind),
                     commands.roles[i],
                     {c.wheels.left, c.wheels.right},
                     {c.twist.linear, c.twist.angular},
                     to(c.go_to)};
  }
  const auto count = std::min<std::size_t>(commands.drawings.size(), out.drawing_capacity);
  for (std::size_t i = 0; i < count; ++i) out.drawings[i] = to(commands.drawings[i]);
  out.drawing_count = static_cast<std::uint32_t>(count);
}

inline void give(const Placement& placement, fulbito_placement& out) {
  for (std::size_t i = 0; i < placement.robots.size(); ++i) {
    if (!placement.robots[i]) continue;
    out.robots.present[i] = 1;
    out.robots.pose[i] = to(*placement.robots[i]);
  }
  if (placement.ball) out.has_ball = 1, out.ball = to(*placement.ball);
}
/// @}

/// Description of a team or navigator in the words of the C interface; it keeps the texts alive.
struct Description {
  explicit Description(const Described& described)
      : name(described.name()), summary(described.summary()), parameters(described.parameters()) {
    for (const Parameter& parameter : parameters) {
      choices.emplace_back();
      for (const std::string& choice : parameter.choices) choices.back().push_back(choice.c_str());
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Parameter& p = parameters[i];
      table.push_back({p.name.c_str(), p.unit.c_str(), p.doc.c_str(), choices[i].data(),
                       static_cast<std::uint32_t>(choices[i].size()), static_cast<std::uint32_t>(p.type),
                       p.default_value, p.minimum, p.maximum});
    }
  }
  explicit Description(const Team& team) : Description(static_cast<const Described&>(team)) {
    version = team.version(), navigator = team.defaultNavigator();
  }
  explicit Description(const Navigator& method) : Description(static_cast<const Described&>(method)) {
    source = method.source(), plans_speed = method.plansSpeed() ? 1 : 0;
  }
  std::string name, version, summary, navigator, source;
  std::uint32_t plans_speed = 0;
  std::vector<Parameter> parameters;
  std::vector<std::vector<const char*>> choices;
  std::vector<fulbito_parameter> table;
};

/// A team behind the C interface.
struct Instance {
  const fulbito_host* host;
  std::unique_ptr<Team> team;
  Observation seen;                     ///< of the present tick
  std::vector<std::string> navigators;  ///< since the last `begin`
};

inline void logTo(const fulbito_host* host, std::string_view line) {
  host->log(host, std::string(line).c_str());
}

/// Runs `call`; an exception becomes a line of the log and a failure.
template <typename Self = Instance, typename Call>
std::int32_t guarded(void* self, const Call& call) {
  Self& instance = *static_cast<Self*>(self);
  try {
    return call(instance);
  } catch (const std::exception& error) {
    logTo(instance.host, std::string("exception: ") + error.what());
  } catch (...) {
    logTo(instance.host, "an exception of an unknown type");
  }
  return 1;
}

/// An object of the class `T` with its parameters set.
template <typename T>
std::unique_ptr<T> made(const fulbito_host* host, const double* values) {
  auto object = std::make_unique<T>();
  object->logTo([host](std::string_view line) { logTo(host, line); });
  for (std::size_t i = 0; i < object->parameters().size(); ++i) object->parameters()[i].set(values[i]);
  return object;
}

template <typename T>
std::unique_ptr<Instance> makeInstance(const fulbito_host* host, const double* values,
                                       const char* navigator) {
  auto instance = std::make_unique<Instance>();
  instance->host = host;
  instance->team = made<T>(host, values);
  Team& team = *instance->team;
  if (navigator != nullptr) team.set("navigator", navigator);
  return instance;
}

/// Gives away what `make` makes; null after an exception, which becomes a line of the log.
template <typename Make>
void* released(const fulbito_host* host, const Make& make) {
  try {
    return make().release();
  } catch (const std::exception& error) {
    logTo(host, error.what());
  } catch (...) {
    logTo(host, "an exception of an unknown type");
  }
  return nullptr;
}

template <typename T>
void* create(const fulbito_host* host, const double* values, const char* navigator) {
  return released(host, [&] { return makeInstance<T>(host, values, navigator); });
}

inline void destroy(void* self) { delete static_cast<Instance*>(self); }

inline std::int32_t begin(void* self, const fulbito_match_info* info) {
  return guarded(self, [&](Instance& instance) {
    Info known = from(*info);
    const void* text = instance.host->get_extension(instance.host, FULBITO_EXT_RULES_TEXT);
    if (text != nullptr) known.rules.text = static_cast<const char*>(text);
    takeCurveWidening(*instance.host, known.robot);
    instance.seen = {};
    instance.team->start(known);
    instance.navigators = instance.team->navigators();
    return 0;
  });
}

inline std::int32_t decide(void* self, const fulbito_observation* seen, fulbito_team_command* command) {
  return guarded(self, [&](Instance& instance) {
    take(*seen, instance.seen);
    give(instance.team->decide(instance.seen), seen->team_size, *command);
    return 0;
  });
}

inline const char* navigatorName(void* self, std::uint32_t index) {
  const Instance& instance = *static_cast<Instance*>(self);
  return index < instance.navigators.size() ? instance.navigators[index].c_str() : nullptr;
}

inline std::int32_t place(void* self, const fulbito_placement_request* request, fulbito_placement* out) {
  return guarded(self, [&](Instance& instance) {
    if (const auto placement = instance.team->place(from(*request))) give(*placement, *out);
    return 0;
  });
}

inline std::int32_t stopped(void* self, const fulbito_stop* stop) {
  return guarded(self, [&](Instance& instance) {
    instance.team->stopped({from(stop->cause), from(stop->now)});
    return 0;
  });
}

inline std::int32_t ready(void* self, const fulbito_observation* seen) {
  return guarded(self, [&](Instance& instance) {
    instance.team->ready(from(*seen));
    return 0;
  });
}

inline std::int32_t ended(void* self, const fulbito_end* end) {
  return guarded(self, [&](Instance& instance) {
    instance.team->ended(from(*end));
    return 0;
  });
}

inline std::int32_t exercise(void* self, const fulbito_observation* seen, const fulbito_exercise* task,
                             fulbito_team_command* command, fulbito_vec2* answer) {
  return guarded(self, [&](Instance& instance) -> std::int32_t {
    take(*seen, instance.seen);
    const auto reply = instance.team->exercise(instance.seen, from(*task));
    if (!reply) return FULBITO_NO_SKILL;
    give(reply->commands, seen->team_size, *command);
    *answer = to(reply->answer);
    return 0;
  });
}

inline const void* extension(const char* name) {
  static constexpr fulbito_navigator_names kNames{navigatorName};
  static constexpr fulbito_restarts kRestarts{place, stopped, ready, ended};
  static constexpr fulbito_exercises kExercises{exercise};
  const std::string_view wanted = name;
  if (wanted == FULBITO_EXT_NAVIGATOR_NAMES) return &kNames;
  if (wanted == FULBITO_EXT_RESTARTS) return &kRestarts;
  if (wanted == FULBITO_EXT_EXERCISES) return &kExercises;
  return nullptr;
}

/// The table of a library with the team `T`; null if its constructor throws.
template <typename T>
const fulbito_library* libraryOf() try {
  static const Description description{T{}};
  static const fulbito_library library{
      FULBITO_ABI,
      sizeof(fulbito_library),
      description.name.c_str(),
      description.version.c_str(),
      description.summary.c_str(),
      description.table.data(),
      static_cast<std::uint32_t>(description.table.size()),
      0,
      description.navigator.empty() ? nullptr : description.navigator.c_str(),
      create<T>,
      destroy,
      begin,
      decide,
      extension};
  return &library;
} catch (...) {
  return nullptr;
}

/// A navigator behind the C interface.
struct Guide {
  const fulbito_host* host;
  std::unique_ptr<Navigator> method;
  NavigationScene scene;           ///< of the present tick
  Guidance guidance;               ///< likewise
  std::vector<fulbito_vec2> path;  ///< of the guidance
};

inline void take(const fulbito_scene& from_scene, const fulbito_host& host, NavigationScene& to) {
  const fulbito_scene& s = from_scene;
  to.tick = s.tick;
  to.dt = s.dt;
  to.self = from(s.self);
  to.goal = from(s.goal);
  to.goal_heading = s.has_heading != 0 ? std::optional(s.goal_heading) : std::nullopt;
  to.tolerance = s.tolerance;
  to.heading_tolerance = s.heading_tolerance;
  to.stop = s.stop != 0;
  to.obstacles.clear();
  for (std::uint64_t i = 0; i < s.obstacle_count; ++i)
    to.obstacles.push_back(
        {from(s.obstacles[i].position), from(s.obstacles[i].velocity), s.obstacles[i].radius});
  to.field = from(*s.field);
  to.robot = from(*s.robot);
  takeCurveWidening(host, to.robot);
}

inline void give(Guide& guide, fulbito_guidance& out) {
  const Guidance& guidance = guide.guidance;
  if (guidance.kind == Guidance::Kind::kTimedPath && guidance.speeds.size() < guidance.path.size())
    throw std::length_error("a path has more points than speeds");
  guide.path.clear();
  for (const Vec2 point : guidance.path) guide.path.push_back(to(point));
  out.kind = static_cast<std::uint32_t>(guidance.kind);
  out.point_count = static_cast<std::uint32_t>(guide.path.size());
  out.path = guide.path.data();
  out.speeds = guidance.speeds.data();
  out.revision = guidance.revision;
  out.wheels = {guidance.wheels.left, guidance.wheels.right};
  out.speed_cap = guidance.speed_cap;
}

template <typename N>
void* createGuide(const fulbito_host* host, const double* values) {
  return released(host, [&] {
    auto guide = std::make_unique<Guide>();
    guide->host = host;
    guide->method = made<N>(host, values);
    return guide;
  });
}

inline void destroyGuide(void* self) { delete static_cast<Guide*>(self); }

inline void resetGuide(void* self) {
  guarded<Guide>(self, [](Guide& guide) {
    guide.method->reset();
    return 0;
  });
}

inline std::int32_t planGuide(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  return guarded<Guide>(self, [&](Guide& guide) {
    take(*scene, *guide.host, guide.scene);
    guide.guidance.speed_cap = guidance->speed_cap;
    guide.method->plan(guide.scene, guide.guidance);
    give(guide, *guidance);
    return 0;
  });
}

inline double headingOfGuide(void* self, fulbito_vec2 point) {
  double heading = std::numeric_limits<double>::quiet_NaN();
  guarded<Guide>(self, [&](Guide& guide) {
    heading = guide.method->heading(from(point));
    return 0;
  });
  return heading;
}

template <typename N>
const Description& descriptionOf() {
  static const Description description{N{}};
  return description;
}

template <typename N>
fulbito_navigator navigatorOf() {
  const Description& d = descriptionOf<N>();
  return {d.name.c_str(),
          d.summary.c_str(),
          d.source.c_str(),
          d.table.data(),
          static_cast<std::uint32_t>(d.table.size()),
          d.plans_speed,
          createGuide<N>,
          destroyGuide,
          resetGuide,
          planGuide,
          headingOfGuide};
}

/// The extension that lists the navigators `N`.
template <typename... N>
const void* navigatorsOf(const char* name) {
  static const std::array<fulbito_navigator, sizeof...(N)> table{navigatorOf<N>()...};
  static const fulbito_navigators navigators{table.data(), static_cast<std::uint32_t>(table.size()), 0};
  return std::string_view(name) == FULBITO_EXT_NAVIGATORS ? &navigators : nullptr;
}

/// The table of a library with the navigators `First` and `N`, without a team; null if a constructor throws.
template <typename First, typename... N>
const fulbito_library* navigatorLibraryOf() try {
  const Description& first = descriptionOf<First>();
  navigatorsOf<First, N...>("");
  static const fulbito_library library{FULBITO_ABI,
                                       sizeof(fulbito_library),
                                       first.name.c_str(),
                                       nullptr,
                                       first.summary.c_str(),
                                       nullptr,
                                       0,
                                       0,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       navigatorsOf<First, N...>};
  return &library;
} catch (...) {
  return nullptr;
}

}  // namespace detail
#pragma GCC visibility pop
}  // namespace fulbito::team

/// Makes the shared library's one symbol for a team of the class `TEAM`, which has a default constructor.
/// Write it once, outside of any namespace. Build with
/// `g++ -std=c++20 -O2 -shared -fPIC -fvisibility=hidden`.
#define FULBITO_TEAM(TEAM)                                                       \
  extern "C" FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) { \
    return fulbito::team::detail::libraryOf<TEAM>();                             \
  }

/// Makes the shared library's one symbol for navigators: classes with a default constructor, separated by
/// commas. Built as a team's library. `fulbito run --navigator ./mine.so:NAME` uses one.
#define FULBITO_NAVIGATORS(...)                                                  \
  extern "C" FULBITO_EXPORT const fulbito_library* fulbito_library_entry(void) { \
    return fulbito::team::detail::navigatorLibraryOf<__VA_ARGS__>();             \
  }
