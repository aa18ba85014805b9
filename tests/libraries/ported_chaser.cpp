// The class that is also a program: see chaser_program.cpp there.
#include "examples/teams/chaser.hpp"

FULBITO_TEAM(Chaser)
