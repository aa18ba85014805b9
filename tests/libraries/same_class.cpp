// Two libraries are built of this file: the same class with another name and parameter.
#include "fulbito/team.hpp"

class MyTeam : public fulbito::team::Team {
 public:
  MyTeam() : Team(SAME_CLASS_NAME) { number(SAME_CLASS_NAME "-gain", gain_, 0.0, 1.0, "", ""); }
  fulbito::team::Commands decide(const fulbito::team::Observation&) override {
    fulbito::team::Commands commands;
    commands.wheels(0, gain_, SAME_CLASS_WHEEL);
    return commands;
  }

 private:
  double gain_ = 0.5;
};

FULBITO_TEAM(MyTeam)
