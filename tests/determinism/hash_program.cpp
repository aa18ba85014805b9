// Prints one hash per fixed scene. It links only the engine, so that it builds quickly with every compiler
// and level.
#include <cinttypes>
#include <cstdio>

#include "bench/scenes.hpp"

int main() {
  for (const fulbito::Scene& scene : fulbito::fixedScenes()) {
    std::printf("%-20s %016" PRIx64 "\n", scene.name.c_str(), fulbito::hashOfRun(scene));
  }
  return 0;
}
