// Teams outside the program: shared libraries and programs in any language, each in a contained process.
// Component `outside`.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "fulbito/detail/child_limits.hpp"
#include "fulbito/strategy.hpp"

namespace fulbito {

/// How teams outside the program run.
struct OutsideOptions {
  /// The place of a shared library.
  enum class Isolation : std::uint8_t {
    kProcess,  ///< in a contained process of its own
    kNone,     ///< in this process, at full speed: for code that you trust
  };
  Isolation isolation = Isolation::kProcess;  ///< programs (`cmd:`) always have a process of their own
  bool sandbox_required = false;              ///< refuse a team if a layer of its containment is missing
  ChildLimits limits;                         ///< limits of each team
  /// The program `fulbito-team-host`; empty: beside the running program, or in its `../libexec/fulbito`.
  std::string host;
  /// The folder of `fulbito_team.py`, which Python programs import; empty: beside the running program, or in
  /// its
  /// `../share/fulbito/python`.
  std::string python_folder;
  std::function<std::int64_t()> clock;  ///< monotonic time [ns]; required
  /// Takes the lines that teams write to standard error; may be called from several threads. Empty: they are
  /// dropped.
  std::function<void(const std::string& team, std::string_view line)> log;
};

/// The source of teams whose specification names a file or a program (docs/write-a-team.md):
///
///     ./myteam.so              a shared library (fulbito/team.h)
///     ./myteam.so:speed=0.7    with settings
///     cmd:python3 myteam.py    a program that speaks the line protocol (docs/team-protocol.md)
///     cmd:python3 myteam.py :speed=0.7
///
/// Each team is started once when its specification is parsed. Errors: kUsage if the file does not exist, or
/// if the team does not start; kMachine if the machine cannot start it; kInterrupted.
TeamCatalogue::Source outsideTeams(OutsideOptions options);

}  // namespace fulbito
