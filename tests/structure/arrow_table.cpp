// Prints the tables of docs/architecture.md.
#include <cstdio>

#include "tests/structure/arrows.hpp"

int main() { std::fputs(fulbito::test::arrowTables().c_str(), stdout); }
