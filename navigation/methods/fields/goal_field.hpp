#pragma once

#include <optional>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/interface/parameters.hpp"

namespace fulbito {

/// How a field leads to the goal where no obstacle is near.
enum class GoalFieldKind {
  kSpiral,   ///< hyperbolic spiral move-to-goal field
  kPosture,  ///< N-posture field
  kBearing,  ///< straight toward the goal, for any arrival heading
};

struct GoalFieldParams {
  GoalFieldKind kind = GoalFieldKind::kSpiral;
  double spiral_radius = 0.0537;      ///< d_e [m] of the terminal spiral
  double spiral_smoothness = 0.0415;  ///< K_r [m]
  double sharpness = 8.0;             ///< n of the posture field
  double guide = 0.02;                ///< d [m] of the posture field's guide point beyond the goal
};

/// Hyperbolic-spiral move-to-goal field (Lim et al., IFAC 2008; docs/navigators.md): the direction [rad] at
/// `p` of curves that reach `goal` with heading `arrival` [rad]. Left of the approach line it is a spiral
/// about a centre `radius` to the goal's left, and right of it the mirror image. In the strip between it is a
/// weighted sum of the two.
double spiralHeading(Vec2 p, Vec2 goal, double arrival, double radius, double smoothness);

/// N-posture field (Robot Soccer Engineering): the bearing to the goal, turned away by `sharpness` times the
/// angle between goal and guide point, at most by pi. At the goal itself it is `arrival`.
double postureHeading(Vec2 p, Vec2 goal, double arrival, double sharpness, double guide);

/// The chosen field for one goal. Without an arrival heading each kind is the bearing to the goal, since a
/// spiral about an arbitrary heading would only lengthen the way.
class GoalField {
 public:
  explicit GoalField(GoalFieldParams params) : params_(params) {}
  void aim(const NavigationGoal& goal);
  Vec2 goal() const { return goal_; }
  double heading(Vec2 p) const;

 private:
  GoalFieldParams params_;
  Vec2 goal_;
  std::optional<double> arrival_;
};

/// Adds the parameters `goal`, `de`, `kr`, `n` and `guide` of the member `goal_field` of `P`.
template <typename P>
std::vector<Parameter<P>> withGoalFieldParameters(std::vector<Parameter<P>> parameters) {
  const GoalFieldParams defaults = P{}.goal_field;
  const auto add = [&](std::string name, double GoalFieldParams::* member, double low, double high,
                       std::string unit, std::string doc) {
    parameters.push_back({{std::move(name),
                           ParameterSpec::Type::kNumber,
                           defaults.*member,
                           low,
                           high,
                           {},
                           std::move(unit),
                           std::move(doc)},
                          [member](P& p, double value) { p.goal_field.*member = value; }});
  };
  parameters.push_back(
      {{"goal",
        ParameterSpec::Type::kChoice,
        static_cast<double>(defaults.kind),
        0.0,
        2.0,
        {"spiral", "posture", "bearing"},
        "",
        "field toward the goal when an arrival heading is wanted"},
       [](P& p, double value) { p.goal_field.kind = static_cast<GoalFieldKind>(static_cast<int>(value)); }});
  add("de", &GoalFieldParams::spiral_radius, 0.005, 0.5, "m", "radius of the spiral field's last turn");
  add("kr", &GoalFieldParams::spiral_smoothness, 0.0, 1.0, "m", "smoothness of the spiral field");
  add("n", &GoalFieldParams::sharpness, 1.0, 20.0, "", "sharpness of the posture field");
  add("guide", &GoalFieldParams::guide, 0.001, 0.3, "m", "posture field's guide point beyond the goal");
  return parameters;
}

}  // namespace fulbito
