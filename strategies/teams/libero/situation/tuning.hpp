#pragma once

#include <vector>

#include "fulbito/detail/parameters.hpp"

namespace fulbito::libero {

/// The tuned numbers of the team (tuning.def), each a parameter such as `libero:aggression=0.7`.
struct Tuning {
#define TUNED(name, value, least, greatest, unit, doc) double name = value;
#include "strategies/teams/libero/situation/tuning.def"
};

/// The parameters of the team, which set the members of `Tuning` with the same names.
std::vector<Parameter<Tuning>> tuningParameters();

}  // namespace fulbito::libero
