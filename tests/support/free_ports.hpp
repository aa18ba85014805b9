#pragma once

namespace fulbito::test {

/// A first port whose ports are this process's alone until it ends. They are below those that the system
/// gives to sockets without a port of their own, and aside from the default ones.
/// @throws std::runtime_error if all are taken
int freePortBase();

}  // namespace fulbito::test
