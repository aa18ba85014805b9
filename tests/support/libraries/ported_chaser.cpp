#include "tests/support/libraries/ported_chaser.hpp"

FULBITO_TEAM(fulbito::test::PortedChaser)
