#include "engine/core/presets.hpp"

namespace fulbito {

Result<RobotPreset> loadRobot(const std::string&) { return RobotPreset{}; }
Result<PhysicsProfile> loadPhysics(const std::string&) { return PhysicsProfile{}; }
Result<FieldGeometry> loadField(const std::string&) { return FieldGeometry{}; }
Result<Layout> loadLayout(const std::string&) { return Layout{}; }

}  // namespace fulbito
