#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/field_geometry.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"

namespace fulbito {

/// All places of a profile that the laws do not allow on the field, for example "penalty: robot 2 of the
/// other team is not beyond the half-way line". The referee repairs such places in every match.
std::vector<std::string> findBadPlaces(const Rules& rules, const FieldGeometry& field,
                                       const RobotModel& robot);

/// A warning if a profile's places seem to be meant for another field: a keeper (robot 0) farther from its
/// goal line than the depth of its goal area, or a place off the field. The match can still be played. Empty:
/// they fit.
std::optional<std::string> findForeignPlaces(const Rules& rules, const FieldGeometry& field,
                                             const RobotModel& robot);

}  // namespace fulbito
