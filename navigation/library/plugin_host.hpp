#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "engine/core/math/random.hpp"
#include "fulbito/team.h"

namespace fulbito {

/// Receives the lines that a library logs. Empty: they go to standard error.
using PluginLog = std::function<void(std::string_view line)>;

/// The simulator's services for one team or navigator of a library.
class PluginHost {
 public:
  /// @param owner  begins each line of the log
  PluginHost(std::string owner, PluginLog log);
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  /// A match begins: the random stream starts anew, and the text of the rules is known.
  void begin(std::uint64_t seed, std::string rules_text);
  /// The slip in curves of the present robots.
  void know(const fulbito_curve_widening& widening) { widening_ = widening; }
  /// The table for the library. It lives as long as this object.
  const fulbito_host* table() const { return &table_; }
  /// Logs a line.
  void log(std::string_view line);  // determinism-ok: a message
  /// The last line that the library has logged; empty: none.
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
