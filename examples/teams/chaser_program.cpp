// `chaser` as a program that speaks the line protocol:
//   g++ -std=c++20 -O2 -I sdk/include examples/teams/chaser_program.cpp -o chaser
#include "chaser.hpp"
#include "fulbito/team_program.hpp"

FULBITO_TEAM_PROGRAM(Chaser)
