#pragma once

#include <array>
#include <vector>

#include "experiments/papers/localization/estimation/pose_estimator.hpp"
#include "experiments/papers/localization/estimation/range_gate.hpp"
#include "experiments/papers/localization/estimation/wall_ahead.hpp"

namespace fulbito::localization {

/// Parameters of the paper's correction. The paper gives no values for them.
struct ThresholdSettings {
  double gate = 0.030;          ///< [m] l0: limit of the gate for the last two echoes
  double threshold = 0.020;     ///< [m] smaller differences are not corrected
  int repeats = 3;              ///< number of successive echoes that must differ by more
  double gain = 0.5;            ///< share of the difference that is corrected; 1 in the paper
  double least = 0.1;           ///< @{ [m] least and greatest range that is used
  double greatest = 6.0;        ///< @}
  double incidence = 0.262;     ///< [rad] 15 degrees, or the cone's half width if it is smaller
  double heading_way = 0.3;     ///< [m] driven along a wall for each correction of the heading
  double heading_gain = 0.3;    ///< share of the heading's difference that is corrected
  double calm_turn_rate = 0.3;  ///< [rad/s] in faster turns echoes are not used
};

/// The paper's scheme: dead reckoning. It moves toward the echoes of walls if they differ by more than a
/// threshold, and turns its heading by the slope of the side echoes along a wall.
class ThresholdEstimator : public PoseEstimator {
 public:
  ThresholdEstimator(const Knowledge& known, const ThresholdSettings& settings);

  void advance(const InnerMotion& motion) override;
  void observe(const EchoTimes& times) override;
  Pose2 pose() const override { return pose_; }

 private:
  /// Echoes of one side along a straight path, for the fit of a line.
  struct WallLine {
    std::vector<Vec2> points;  ///< [m] path length, and difference between echo and dead reckoning
  };

  void correct(Beam beam, const WallAhead& wall, double difference);
  void noteSlope(Beam beam, const WallAhead& wall, double range);
  void turnBySlope(double slope);
  void forgetSlopes();
  double steepest() const;
  bool usable(const WallAhead& wall, double range) const;

  Knowledge known_;
  ThresholdSettings settings_;
  Pose2 pose_;
  Pose2 reckoned_;          ///< pose by encoders and gyro alone, for the gates
  double way_ = 0.0;        ///< [m] driven since the slopes began
  double sideways_ = 0.0;   ///< [m] driven across the wall's direction since then, by dead reckoning
  double turn_rate_ = 0.0;  ///< [rad/s] in the last tick
  std::array<RangeGate, kBeams.size()> gates_;
  std::array<std::vector<double>, kBeams.size()> beyond_;  ///< [m] successive differences
  std::array<WallLine, kBeams.size()> lines_;
};

}  // namespace fulbito::localization
