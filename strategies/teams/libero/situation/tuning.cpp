#include "strategies/teams/libero/situation/tuning.hpp"

namespace fulbito::libero {

std::vector<Parameter<Tuning>> tuningParameters() {
  return {
#define TUNED(name, value, least, greatest, unit, doc) \
  number(#name, &Tuning::name, least, greatest, unit, doc),
#include "strategies/teams/libero/situation/tuning.def"
  };
}

}  // namespace fulbito::libero
