#pragma once

#include <cstddef>

class b2World;

namespace fulbito {

/// Enlarges an empty world's memory pools for `bodies` crowded bodies, so that stepping allocates nothing.
/// Box2D has no function for it, so this adds overlapping discs and removes them again.
void reserveContacts(b2World& world, std::size_t bodies);

}  // namespace fulbito
