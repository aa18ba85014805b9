#pragma once

#include <nanobind/nanobind.h>

#include "fulbito/strategy.hpp"
#include "python/bindings/python_calls.hpp"

namespace fulbito::python {

/// How teams that are files or programs are contained; see `fulbito match --help`.
struct Containment {
  std::string isolate = "process";  ///< for shared libraries: process or none
  std::string sandbox = "best";     ///< best or require
  double memory_mb = 1024.0;        ///< [MiB] of each team
  int processes = 64;               ///< processes and threads of each team
  bool network = false;             ///< teams may use the network
};

/// Built-in teams, and teams that are files, programs or clients of the league. They find the companions of
/// the program in `bin` of the package. Their stderr goes to the stderr of this process. Errors: kUsage.
TeamCatalogue catalogueOf(const Containment& containment);

/// A team of a match: a specification (str), or a Python object or class like fulbito.team.Team. A class is
/// called for each match; an object plays all of them, so it must not play two at once. `failure` keeps what
/// it raises; the match is then abandoned. Needs the GIL. Throws the errors of `TeamCatalogue::parse`, and
/// UsageError.
TeamChoice teamFrom(nanobind::handle team, const TeamCatalogue& catalogue, const SharedFailure& failure);

}  // namespace fulbito::python
