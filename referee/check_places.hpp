#pragma once

#include <string>
#include <vector>

#include "engine/core/field_geometry.hpp"
#include "engine/core/robot_model.hpp"
#include "referee/rules.hpp"

namespace fulbito {

/// What is wrong with a profile's own places: of each restart the first that its law does not allow on that
/// field, as "penalty: robot 2 of the other team is not beyond the half-way line". The referee repairs such
/// places in every match; empty where nothing is to be repaired.
std::vector<std::string> findBadPlaces(const Rules& rules, const FieldGeometry& field,
                                       const RobotModel& robot);

}  // namespace fulbito
