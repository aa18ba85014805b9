// Navigation of one robot: methods that say where to drive, and the pilot that turns their word into wheel
// speeds. A method of your own implements `Navigator`. Component `navigation`.
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
#include "fulbito/models.hpp"
#include "fulbito/values.hpp"

namespace fulbito {

/// A desired direction of travel at every point of the field.
class HeadingField {
 public:
  virtual ~HeadingField() = default;
  /// Direction [rad] of travel for a robot at `p`. Finite for every finite `p`.
  virtual double heading(Vec2 p) const = 0;
};

/// In which form a navigator says where to drive.
enum class GuidanceKind {
  kField,      ///< `field` is set
  kPath,       ///< `path` is set; the follower chooses the speed
  kTimedPath,  ///< `path` and `speeds` are set: the method planned its own speed profile
  kWheels,     ///< `wheels` is set: the method controls the robot itself
};

/// A navigator's output. Views point into the navigator and stay valid until its next call.
struct Guidance {
  GuidanceKind kind = GuidanceKind::kField;  ///< which of the members below are set
  const HeadingField* field = nullptr;       ///< null unless `kind` is kField
  std::span<const Vec2> path;                ///< [m] robot's place to goal, at least 2 points, any spacing
  std::span<const double> speeds;            ///< [m/s] at each path point
  std::uint64_t revision = 0;  ///< changes whenever `path` or `speeds` do, so that followers can cache
  WheelSpeeds wheels;          ///< [rad/s]
  double speed_cap = std::numeric_limits<double>::infinity();  ///< [m/s] present speed limit
};

/// Guidance by `field`, which must outlive it.
inline Guidance guidanceBy(const HeadingField& field) {
  Guidance guidance;
  guidance.kind = GuidanceKind::kField;
  guidance.field = &field;
  return guidance;
}

/// A round obstacle as a navigator sees it. Boxes are already covered by discs.
struct DiscObstacle {
  Vec2 position;        ///< [m] of its middle, now
  double radius = 0.0;  ///< [m] of the obstacle itself, not inflated by the robot
  Vec2 velocity;        ///< [m/s]
};

/// The robot's goal.
struct NavigationGoal {
  Vec2 position;                      ///< [m] where the robot's centre shall get to
  std::optional<double> heading;      ///< [rad] wanted on arrival
  double tolerance = 0.03;            ///< [m]
  double heading_tolerance = 0.1745;  ///< [rad]
  bool stop = false;                  ///< stop there; otherwise the robot may pass at speed
};

/// Everything that a navigator knows in one control tick. Views are valid during the call only.
struct NavigationScene {
  Tick tick = 0;                            ///< counts control ticks; never goes back within a trial
  double dt = 1.0 / 60.0;                   ///< [s] control period
  RobotState self;                          ///< the robot as it is known
  NavigationGoal goal;                      ///< where it shall go
  std::span<const DiscObstacle> obstacles;  ///< the other bodies, in any order
  const FieldGeometry* field = nullptr;     ///< never null
  const RobotModel* robot = nullptr;  ///< never null; its max_wheel_speed is the speed limit of this run
};

/// One navigation method. An instance belongs to one robot and keeps its memory between ticks. Contract:
/// `plan` returns finite numbers for any finite scene, allocates nothing once warm, and reads no clock.
class Navigator {
 public:
  virtual ~Navigator() = default;
  /// Forgets everything: the next call starts a new trial.
  virtual void reset() = 0;
  /// Plans the motion in the present scene. Called once per control tick.
  virtual Guidance plan(const NavigationScene& scene) = 0;
};

/// Turns guidance into the robot's wanted twist; `limitTwist` and the kinematics come after it.
class Follower {
 public:
  virtual ~Follower() = default;
  /// Forgets everything: the next call starts a new trial.
  virtual void reset() = 0;
  /// Wanted twist, not yet limited. `guidance.kind` is not kWheels (that needs no follower).
  virtual Twist follow(const Guidance& guidance, const NavigationScene& scene) = 0;
};

/// One documented, typed parameter of a navigator or follower, as `fulbito list navigators` shows it.
struct ParameterSpec {
  /// What values a parameter takes; a specification writes all of them as text.
  enum class Type { kNumber, kInteger, kFlag, kChoice };
  std::string name;                  ///< as in `name=value`
  Type type = Type::kNumber;         ///< what values it takes
  double default_value = 0.0;        ///< flags 0/1; choices the index
  double minimum = 0.0;              ///< least value allowed
  double maximum = 0.0;              ///< largest value allowed
  std::vector<std::string> choices;  ///< of kChoice: the names of its values
  std::string unit;                  ///< e.g. "m/s"; empty: none
  std::string doc;                   ///< one line for people
};

/// A `name=value` pair of a specification such as `bezier:clearance=0.02`.
struct Setting {
  std::string name;   ///< of the parameter
  std::string value;  ///< as written
};

/// The registry's entry of one navigation method.
struct NavigatorInfo {
  std::string name;                       ///< as in specifications
  std::string summary;                    ///< one line
  std::string source;                     ///< paper, section
  bool plans_speed = false;               ///< returns its own speed profile or wheel speeds; tables mark it
  std::vector<ParameterSpec> parameters;  ///< its own; `commonParameters` has those of all
  /// Creates the navigator from settings. Errors: kUsage.
  std::function<Result<std::unique_ptr<Navigator>>(const std::vector<Setting>&)> make;
};

/// One robot's navigation stage: navigator, follower, escape from walls, limiter and kinematics in one call a
/// tick. Methods that control the wheels themselves get neither follower nor escape.
class Pilot {
 public:
  /// @param follower  null: the follower that all built-in methods share
  /// @param wall_escape  whether the robot gets away from walls that leave it no room to turn
  explicit Pilot(std::unique_ptr<Navigator> navigator, std::unique_ptr<Follower> follower = nullptr,
                 bool wall_escape = true);
  Pilot(Pilot&&) noexcept;             ///< The one moved from can only be destroyed or assigned to.
  Pilot& operator=(Pilot&&) noexcept;  ///< As above.
  ~Pilot();

  /// Forgets everything: the next tick starts a new trial.
  void reset();
  /// Wheel speeds for this tick, within the robot's limits and always finite. Allocates nothing once warm.
  WheelSpeeds drive(const NavigationScene& scene);
  /// What the navigator wanted at the last tick. Valid until the next `drive` or `reset`.
  const Guidance& guidance() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Name of the navigator that is used where none is named.
inline constexpr const char* kDefaultNavigator = "bspline-time";

/// All navigation methods, in the order in which tables list them.
std::span<const NavigatorInfo> navigators();

/// Parameters that every method takes beside its own: `follower=preview|classic` and
/// `wall_escape=on|off`.
std::span<const ParameterSpec> commonParameters();

/// A specification such as `bezier:clearance=0.02,follower=classic`, taken apart and checked by name.
struct NavigatorChoice {
  const NavigatorInfo* info = nullptr;  ///< entry of `navigators()`
  std::string text;                     ///< as given
  std::vector<Setting> settings;        ///< the method's own
  bool classic_follower = false;        ///< `follower=classic`
  bool wall_escape = true;              ///< `wall_escape=on`
};

/// Errors: kUsage naming the unknown method or parameter, with a suggestion.
Result<NavigatorChoice> parseNavigator(const std::string& specification);

/// A fresh pilot for the choice.
Result<std::unique_ptr<Pilot>> makePilot(const NavigatorChoice& choice);

}  // namespace fulbito
