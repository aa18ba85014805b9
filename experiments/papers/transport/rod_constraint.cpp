#include "experiments/papers/transport/rod_constraint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/models.hpp"

namespace fulbito {

RodView viewRod(const PartPath& path, const PartPlace& lead, const PartPlace& follower) {
  const Pose2 a = path.pose(lead.part, lead.q), b = path.pose(follower.part, follower.q);
  const Vec2 rod = a.position - b.position;
  return {rod, dot(rod, math::unit(a.heading)), dot(rod, math::unit(b.heading))};
}

double slaveSpeed(double master_speed, double along_master, double along_slave) {
  const double wanted = master_speed * along_master;
  if (along_slave != 0.0) return wanted / along_slave;
  return wanted == 0.0 ? 0.0 : std::copysign(std::numeric_limits<double>::infinity(), wanted);
}

double onRod(const PartPath& path, Vec2 other, PartPlace slave, double rod) {
  constexpr double kLargestStep = 0.005;  // [m]
  constexpr double kEnough = 1e-12;       // [m]
  for (int i = 0; i < 3; ++i) {
    const Pose2 pose = path.pose(slave.part, slave.q);
    const Vec2 d = pose.position - other;
    const double change = 2 * dot(d, math::unit(pose.heading));
    const double excess = squaredNorm(d) - rod * rod;
    if (change == 0.0) break;
    const double step = std::clamp(-excess / change, -kLargestStep, kLargestStep);
    slave.q += step;
    if (std::abs(step) < kEnough) break;
  }
  return slave.q;
}

}  // namespace fulbito
