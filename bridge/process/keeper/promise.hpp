#pragma once

#include "bridge/process/keeper/order.hpp"

namespace fulbito::keeper {

/// Whether the limits that the launching program has leave a team what it may have. A team that gets less
/// could fail by no fault of its own. Notes what is missing.
bool canKeepPromise(Order& order);

}  // namespace fulbito::keeper
