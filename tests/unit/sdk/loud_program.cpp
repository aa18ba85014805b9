#include <iostream>
#include <stdexcept>

#include "fulbito/team_program.hpp"

/// A team that prints to every stream, and fails at tick 60.
class Loud final : public fulbito::team::Team {
 public:
  Loud() : Team("loud") { std::cout << "made" << std::endl; }
  fulbito::team::Commands decide(const fulbito::team::Observation& seen) override {
    std::cout << "said by cout" << std::endl;
    std::printf("said by printf\n");
    log("said by log");
    if (seen.tick == 60) throw std::runtime_error("no idea");
    return {};
  }
};

FULBITO_TEAM_PROGRAM(Loud)
