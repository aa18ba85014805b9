#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "engine/core/math/random.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// Receives the lines that a library logs. If it is empty, they go to standard error.
using PluginLog = std::function<void(std::string_view line)>;

/// The simulator's services for one team or navigator of a library.
class PluginHost {
 public:
  /// @param owner  start of each line in the log
  PluginHost(std::string owner, PluginLog log);
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  /// Starts a match: restarts the random stream and stores the text of the rules.
  void begin(std::uint64_t seed, std::string rules_text);
  /// Stores the slip in curves of the robots.
  void know(const fulbito_curve_widening& widening) { widening_ = widening; }
  /// The table of host functions for the library, valid as long as this object.
  const fulbito_host* table() const { return &table_; }
  /// Logs a line.
  void log(std::string_view line);  // determinism-ok: a message
  /// The last line that the library has logged, or an empty text.
  const std::string& lastLine() const { return last_line_; }

 private:
  std::string owner_;
  PluginLog log_;
  std::string last_line_;
  std::string rules_text_;
  fulbito_curve_widening widening_{};
  Rng rng_{0, Stream::kLibraryTeam};
  fulbito_host table_{};
};

}  // namespace fulbito
