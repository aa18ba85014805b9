#pragma once

#include <optional>

#include "engine/core/config/schema.hpp"
#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/detail/layout.hpp"
#include "fulbito/models.hpp"

/// The keys of every configuration struct, and the checks beyond each key's own limits.
namespace fulbito {

/// Largest number of obstacles in a layout.
inline constexpr std::size_t kMaxObstacles = 500;

/// @{ The keys of one table, bound to `value`.
Schema schemaOf(RobotModel& value);
Schema schemaOf(BallModel& value);
Schema schemaOf(PhysicsProfile& value);
Schema schemaOf(FieldGeometry& value);
Schema layoutSchema(Layout& value);  ///< [layout]
Schema startSchema(Layout& value);   ///< [start]
Schema goalSchema(Layout& value);    ///< [goal]
Schema schemaOf(ObstacleSpec& value);
/// @}

/// @{ The first flaw of a value: outside its limits, or in conflict with another value.
std::optional<Flaw> findFlaw(const RobotModel& robot);
std::optional<Flaw> findFlaw(const BallModel& ball);
std::optional<Flaw> findFlaw(const PhysicsProfile& physics);
std::optional<Flaw> findFlaw(const FieldGeometry& field);
std::optional<Flaw> findFlaw(const Layout& layout);
/// Also checks that start, goal and obstacle positions are inside the field.
std::optional<Flaw> findFlaw(const Layout& layout, const FieldGeometry& field);
/// @}

}  // namespace fulbito
