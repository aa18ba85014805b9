#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/robot_model.hpp"
#include "referee/rules/rules.hpp"

namespace fulbito {

/// What is wrong with a profile's own places: of each restart all that its law does not allow on that
/// field, as "penalty: robot 2 of the other team is not beyond the half-way line". The referee repairs such
/// places in every match; empty where nothing is to be repaired.
std::vector<std::string> findBadPlaces(const Rules& rules, const FieldGeometry& field,
                                       const RobotModel& robot);

/// Whether a profile's places look as if they were written for another field, and what to do then: a keeper
/// (robot 0) that stands farther before its goal line than its goal area is deep, or a place off the field.
/// The match can be played all the same. Empty: they fit.
std::optional<std::string> findForeignPlaces(const Rules& rules, const FieldGeometry& field,
                                             const RobotModel& robot);

}  // namespace fulbito
