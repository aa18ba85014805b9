#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"

NB_MODULE(_core, m) {
  using namespace fulbito::python;
  m.doc() = "The C++ side of the package fulbito. Use the package's own modules; this one may change.";
  bindErrors(m);
  bindInfo(m);
  bindAgent(m);
  bindWindow(m);
  bindEnvironments(m);
  bindMatchSource(m);
  bindVector(m);
  bindPlay(m);
  bindRecording(m);
  bindWorld(m);
  bindCompare(m);
  bindDrillSource(m);
  bindNavigationSource(m);
}
