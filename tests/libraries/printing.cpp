// A team that uses the standard streams as its author likes.
#include <cstdio>

#include "fulbito/team.hpp"

class Printing : public fulbito::team::Team {
 public:
  Printing() : Team("printing") {}
  void begin(const fulbito::team::Info&) override {
    log("logged");
    if (std::getchar() == EOF) std::puts("nothing to read");
  }
  fulbito::team::Commands decide(const fulbito::team::Observation& seen) override {
    std::printf("printed %d\n", static_cast<int>(seen.tick));
    std::fflush(stdout);
    fulbito::team::Commands commands;
    commands.wheels(0, 4.0, 4.0);
    return commands;
  }
};

FULBITO_TEAM(Printing)
