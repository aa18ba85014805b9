#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Whether the limits of the launching program leave the team what its own limits promise. A team that gets
/// less could fail by no fault of its own. Notes what is missing.
bool canKeepPromise(Order& order);

}  // namespace fulbito::keeper
