// Private header of engine/sim: not installed.
#pragma once

#include <cstddef>

class b2World;

namespace fulbito {

/// Makes an empty world's pools large enough for `bodies` moving bodies that crowd together, so that stepping
/// them allocates nothing. Box2D has no call for it: some discs meet in one place and are taken out again.
void reserveContacts(b2World& world, std::size_t bodies);

}  // namespace fulbito
