#include "tests/libraries/ported_chaser.hpp"

FULBITO_TEAM(fulbito::test::PortedChaser)
