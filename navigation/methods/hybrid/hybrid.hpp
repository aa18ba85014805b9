#pragma once

#include <array>
#include <vector>

#include "engine/core/models/echo_scene.hpp"
#include "engine/core/models/sonar_model.hpp"
#include "navigation/interface/parameters.hpp"
#include "navigation/methods/hybrid/avoidance_table.hpp"
#include "navigation/methods/hybrid/crowding.hpp"
#include "navigation/methods/hybrid/side_balance.hpp"
#include "navigation/methods/hybrid/sonar_drive.hpp"
#include "navigation/methods/reactive/nearness_motion.hpp"
#include "navigation/obstacles/echo_map.hpp"

namespace fulbito {

/// The behaviours of the hybrid.
enum class HybridMode {
  kGoal,     ///< nothing is near: at the goal
  kBeside,   ///< something is beside: vector field
  kAhead,    ///< an occupancy box is hit: limit cycle
  kCrowded,  ///< obstacles stand densely: nearness diagram
};

/// The variants of the method.
enum class HybridVariant {
  kOurs,            ///< with range sensors by `SonarDrive`, with a known map as published with our additions
  kWithoutDiagram,  ///< limit cycle and vector field, with a memory of echoes: what the paper compares with
  kAsPrinted,       ///< the paper's rules on the present readings, without our additions
};

/// Settings of the hybrid. Lengths are those of the paper's robot of 22 cm radius; the robot's radius over
/// 22 cm scales them.
struct HybridParams {
  double range = 1.5;          ///< d_max [m]
  double security = 0.8;       ///< d_s [m]
  double near = 0.3;           ///< I1 [m]
  double far = 0.6;            ///< I2 [m]
  double box_width = 0.05;     ///< [m]
  int boxes = 6;               ///< per side
  double orbit_margin = 0.08;  ///< [m] that an orbit adds to the robot's radius
  double mu = 2.0;             ///< convergence to the orbit
  double crowding = 1.5;       ///< gaps narrower than this many robot diameters are crowded
  double near_zone = 0.1;      ///< [m] anything so near to the body is crowded
  double hold = 0.2;           ///< [s] for which a mode is kept at least
  double side_hold = 2.0;      ///< [s] after an orbit in which the next one keeps its side
  double gap_margin = 0.008;   ///< [m] added to half the robot's width where gaps are tested
  double braking = 0.25;       ///< share of the wheel acceleration for stopping
  double memory = 2.0;         ///< [s] for which echoes are remembered
};

/// The hybrid of P.-G. Kim et al. (2006): limit cycle round what is ahead, vector field past what is beside,
/// nearness diagram where obstacles stand densely, with eight ultrasonic sensors in front.
///
/// A robot without range sensors computes what ideal ones would read among the known obstacles and walls, and
/// its diagram shows these exactly. Where it has range sensors, the three behaviours know too little: eight
/// cones show no gap at once. There `SonarDrive` takes their place.
///
/// Ours: the arbitration's thresholds, the memory of echoes without the diagram, the hold of sides,
/// `roomToTurn`, `SideBalance`, braking before what lies straight ahead, and `SonarDrive`.
class Hybrid : public Navigator, public HeadingField {
 public:
  using Params = HybridParams;
  explicit Hybrid(Params params = {}) : Hybrid(params, HybridVariant::kOurs) {}
  void reset() override;
  Guidance plan(const NavigationScene& scene) override;
  double heading(Vec2) const override { return direction_; }
  /// The present behaviour.
  HybridMode mode() const { return mode_; }

 protected:
  Hybrid(const Params& params, HybridVariant variant);

 private:
  /// One tick's knowledge, robot frame, with lengths scaled to the robot.
  struct Situation {
    double scale = 1.0;
    Vec2 goal;
    std::optional<FrontOrbit> orbit;
    double widest_gap = 0.0;       ///< [m] gaps below it are narrow
    bool crowded = false;          ///< narrow, or something is very near
    std::optional<double> beside;  ///< [rad] direction past what is beside
  };
  /// What a mode wants.
  struct Way {
    double direction = 0.0;    ///< [rad] robot frame
    double speed_share = 1.0;  ///< of the top speed
  };

  Guidance planByRules(const NavigationScene& scene);
  void listen(const NavigationScene& scene, const Situation& situation);
  void scanReadings();
  void readIdeally(const NavigationScene& scene);
  void placeEchoes(double goal_range);
  double nearestToBody(const NavigationScene& scene) const;
  Situation situationOf(const NavigationScene& scene);
  HybridMode wantedMode(const Situation& situation) const;
  void changeMode(HybridMode wanted, const Situation& situation, Tick tick, bool keeps_side);
  bool passesLeft(const Situation& situation) const;
  Way modeWay(const Situation& situation, const NavigationScene& scene) const;
  Way wayOf(const Situation& situation, const NavigationScene& scene) const;
  Way diagramWay(const Situation& situation, const NavigationScene& scene) const;
  double brakingSpeed(const NavigationScene& scene) const;

  Params params_;
  HybridVariant variant_;
  SectorCircle circle_;
  SonarDrive drive_;
  EchoMap memory_;
  EchoScene known_;
  std::vector<SonarSpec> sonars_;       ///< of the ideal readings
  Vec2 sonars_body_;                    ///< [m] length and width of the body that they are on
  std::vector<RangeReading> readings_;  ///< the scene's, or ideal ones
  std::vector<Vec2> echoes_;            ///< [m] robot frame: heard, on the axes
  std::vector<SectorHit> seen_;
  std::vector<SectorHit> diagram_;  ///< of that, what lies within d_max
  SideBalance balance_;
  HybridMode mode_ = HybridMode::kGoal;
  Tick mode_since_ = 0;
  bool clockwise_ = true;   ///< of the present orbit
  Tick orbit_last_ = 0;     ///< when the robot was last on one
  double direction_ = 0.0;  ///< [rad] world frame
};

/// The same without the nearness diagram: the method that the paper compares with.
class HybridWithoutNd final : public Hybrid {
 public:
  explicit HybridWithoutNd(Params params = {}) : Hybrid(params, HybridVariant::kWithoutDiagram) {}
};

/// The paper's rules as printed: present readings only, table 1 and (10) unchanged, no hold, no braking.
class HybridRaw final : public Hybrid {
 public:
  explicit HybridRaw(Params params = {}) : Hybrid(params, HybridVariant::kAsPrinted) {}
};

}  // namespace fulbito
