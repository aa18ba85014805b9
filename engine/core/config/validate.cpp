#include "engine/core/config/schemas.hpp"

namespace fulbito {

Result<void> validate(const RobotModel& robot) { return asResult(findFlaw(robot)); }
Result<void> validate(const BallModel& ball) { return asResult(findFlaw(ball)); }
Result<void> validate(const PhysicsProfile& physics) { return asResult(findFlaw(physics)); }
Result<void> validate(const FieldGeometry& field) { return asResult(findFlaw(field)); }
Result<void> validate(const Layout& layout) { return asResult(findFlaw(layout)); }
Result<void> validate(const Layout& layout, const FieldGeometry& field) {
  return asResult(findFlaw(layout, field));
}

}  // namespace fulbito
