#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "bridge/outside/bounded_log.hpp"
#include "bridge/process/child.hpp"

namespace fulbito::wire {

/// A client's program that runs. What it prints goes to the log.
class ClientProgram {
 public:
  /// @param log  takes its lines
  ClientProgram(Child child, TeamLog log) : child_(std::move(child)), log_(std::move(log)) {}

  /// Passes on what it has printed. False once it has ended or closed its standard output.
  bool look() { return read(0.0); }
  /// How it ended. Ends it if it still runs.
  ChildEnd end();
  /// Gives it time to end by itself: closes its standard input, and waits for at most `looks` times 50 ms.
  void waitForEnd(int looks);

  const Containment& containment() const { return child_.containment(); }

 private:
  bool read(double seconds);

  Child child_;
  BoundedLog log_;
  std::string out_, errors_;
};

}  // namespace fulbito::wire
