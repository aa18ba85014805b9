// Navigation of one robot: navigators give guidance, and the pilot turns guidance into wheel speeds. A method
// of your own implements `Navigator`. Component `navigation`.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/models.hpp"

namespace fulbito {

/// A desired direction of travel at every point of the field.
class HeadingField {
 public:
  virtual ~HeadingField() = default;
  /// Direction [rad] of travel for a robot at `p`. Finite for every finite `p`.
  virtual double heading(Vec2 p) const = 0;
};

/// The forms of guidance.
enum class GuidanceKind {
  kField,      ///< `field` is set
  kPath,       ///< `path` is set; the follower chooses the speed
  kTimedPath,  ///< `path` and `speeds` are set: the method planned its own speed profile
  kWheels,     ///< `wheels` is set: the method controls the wheels itself
};

/// A navigator's output. Views point into the navigator and stay valid until its next call.
struct Guidance {
  GuidanceKind kind = GuidanceKind::kField;  ///< selects the members below
  const HeadingField* field = nullptr;       ///< null unless `kind` is kField
  std::span<const Vec2> path;                ///< [m] from robot to goal, at least 2 points, any spacing
  std::span<const double> speeds;            ///< [m/s] speed at each path point
  std::uint64_t revision = 0;  ///< changes whenever `path` or `speeds` do, so that followers can cache
  WheelSpeeds wheels;          ///< [rad/s] for kWheels
  double speed_cap = std::numeric_limits<double>::infinity();  ///< [m/s] present speed limit
};

/// Guidance by `field`, which must outlive the guidance.
inline Guidance guidanceBy(const HeadingField& field) {
  Guidance guidance;
  guidance.kind = GuidanceKind::kField;
  guidance.field = &field;
  return guidance;
}

/// A round obstacle for navigators. Discs also cover the boxes.
struct DiscObstacle {
  Vec2 position;        ///< [m] its centre now
  double radius = 0.0;  ///< [m] the obstacle's own radius, not inflated by the robot
  Vec2 velocity;        ///< [m/s]
};

/// The robot's goal.
struct NavigationGoal {
  Vec2 position;                      ///< [m] target of the robot's centre
  std::optional<double> heading;      ///< [rad] on arrival; empty: any
  double tolerance = 0.03;            ///< [m] distance that counts as arrival
  double heading_tolerance = 0.1745;  ///< [rad] difference that counts as the wanted heading
  bool stop = false;                  ///< stop at the goal; otherwise the robot may pass it at speed
};

/// A reading of one of the robot's own range sensors, e.g. a sonar: the nearest thing within a cone.
struct RangeReading {
  Pose2 mount;             ///< robot frame: the sensor's place and the direction of its axis
  double half_cone = 0.0;  ///< [rad] between the axis and the edge of the cone
  double greatest = 0.0;   ///< [m] nothing farther is sensed
  bool heard = false;      ///< whether it senses anything
  double range = 0.0;      ///< [m] from the sensor; `greatest` if it senses nothing
};

/// A navigator's knowledge at one control tick. Views are valid during the call only.
struct NavigationScene {
  Tick tick = 0;                            ///< counts control ticks; never goes back within a trial
  double dt = 1.0 / 60.0;                   ///< [s] control period
  RobotState self;                          ///< the robot's state as far as known
  NavigationGoal goal;                      ///< the robot's goal
  std::span<const DiscObstacle> obstacles;  ///< the other bodies, in any order
  const FieldGeometry* field = nullptr;     ///< never null
  const RobotModel* robot = nullptr;  ///< never null; its max_wheel_speed is the speed limit of this trial
  /// Readings of the robot's range sensors at this tick. Empty: it has none, and `obstacles` is all that it
  /// knows. Where the robot knows only what its sensors heard, `obstacles` are small discs at echoes.
  std::span<const RangeReading> ranges;
};

/// One navigation method. An instance belongs to one robot and keeps its memory between ticks. Contract:
/// `plan` returns finite numbers for any finite scene, allocates nothing once warm, and reads no clock.
class Navigator {
 public:
  virtual ~Navigator() = default;
  /// Resets all memory: the next call starts a new trial.
  virtual void reset() = 0;
  /// Plans the motion in the present scene. Called once per control tick.
  virtual Guidance plan(const NavigationScene& scene) = 0;
};

/// Turns guidance into the robot's wanted twist; `limitTwist` and the kinematics come after it.
class Follower {
 public:
  virtual ~Follower() = default;
  /// Resets all memory: the next call starts a new trial.
  virtual void reset() = 0;
  /// The wanted twist before limits. `guidance.kind` is never kWheels, which needs no follower.
  virtual Twist follow(const Guidance& guidance, const NavigationScene& scene) = 0;
};

/// One documented, typed parameter of a navigator, follower or team, as `fulbito list` shows it.
struct ParameterSpec {
  /// The types of values; a specification writes all of them as text.
  enum class Type { kNumber, kInteger, kFlag, kChoice };
  std::string name;                  ///< as in `name=value`
  Type type = Type::kNumber;         ///< type of its values
  double default_value = 0.0;        ///< of a flag: 0 or 1; of a choice: its index
  double minimum = 0.0;              ///< least allowed value
  double maximum = 0.0;              ///< largest allowed value
  std::vector<std::string> choices;  ///< for kChoice: the names of its values
  std::string unit;                  ///< e.g. "m/s"; empty: none
  std::string doc;                   ///< one line for people
};

/// A `name=value` pair of a specification such as `bezier:clearance=0.02`.
struct Setting {
  std::string name;   ///< name of the parameter
  std::string value;  ///< as written
};

/// The registry's entry of one navigation method.
struct NavigatorInfo {
  std::string name;                       ///< as in specifications
  std::string summary;                    ///< one line
  std::string source;                     ///< paper, section
  bool plans_speed = false;               ///< gives its own speed profile or wheel speeds; tables mark it
  std::vector<ParameterSpec> parameters;  ///< the method's own; all methods share `commonParameters`
  /// Creates the navigator from settings. Errors: kUsage.
  std::function<Result<std::unique_ptr<Navigator>>(const std::vector<Setting>&)> make;
  bool reads_ranges = false;  ///< uses `NavigationScene::ranges` where there are any
};

/// The rule for a robot at a wall, applied after the follower: `wall_escape=on|off|zones`.
enum class WallRule {
  kEscape,  ///< a robot without room to turn first drives away from the wall (docs/followers.md)
  kNone,    ///< no rule: the follower's twist stays as it is
  kZones,   ///< the boundary rule of Jung & Lee (2015): unequal wheel speeds in a wall's zone
};

/// One robot's navigation stage: navigator, follower, escape from walls, limiter and kinematics, with one
/// call per tick. Methods that control the wheels themselves use neither follower nor escape.
class Pilot {
 public:
  /// @param follower  null: the default follower of all built-in methods
  /// @param wall_rule  rule for the robot at walls
  explicit Pilot(std::unique_ptr<Navigator> navigator, std::unique_ptr<Follower> follower = nullptr,
                 WallRule wall_rule = WallRule::kEscape);
  Pilot(Pilot&&) noexcept;             ///< A moved-from pilot can only be destroyed or assigned to.
  Pilot& operator=(Pilot&&) noexcept;  ///< As above.
  ~Pilot();

  /// Resets all memory: the next tick starts a new trial.
  void reset();
  /// Wheel speeds for this tick, within the robot's limits and always finite. Allocates nothing once warm.
  WheelSpeeds drive(const NavigationScene& scene);
  /// The navigator's guidance at the last tick. Valid until the next `drive` or `reset`.
  const Guidance& guidance() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Name of the default navigator.
inline constexpr const char* kDefaultNavigator = "bspline-time";

/// All navigation methods, in the order of the tables.
std::span<const NavigatorInfo> navigators();

/// Parameters that each method takes in addition to its own: `follower=preview|classic` and
/// `wall_escape=on|off|zones`.
std::span<const ParameterSpec> commonParameters();

/// A parsed specification such as `bezier:clearance=0.02,follower=classic`, with checked names. Copies share
/// the entry.
struct NavigatorChoice {
  std::shared_ptr<const NavigatorInfo> info;  ///< entry of `navigators()` or of a loaded library
  std::string text;                           ///< as given
  std::vector<Setting> settings;              ///< settings of the method's own parameters
  bool classic_follower = false;              ///< `follower=classic`
  WallRule wall_rule = WallRule::kEscape;     ///< `wall_escape=on`
};

/// Parses a specification. `./mine.so:mine:gain=2` names a navigator of a shared library, which is loaded
/// into this process; its interface is `fulbito/team.h`. Errors: kUsage naming the unknown method or
/// parameter, with a suggestion; kIo and kBadInput naming the library.
Result<NavigatorChoice> parseNavigator(const std::string& specification);
/// The same for the methods of `navigators()` only: for specifications from a source that is not trusted.
Result<NavigatorChoice> parseBuiltInNavigator(const std::string& specification);

/// Creates a new pilot from a choice. Errors: kUsage.
Result<std::unique_ptr<Pilot>> makePilot(const NavigatorChoice& choice);

}  // namespace fulbito
