#pragma once

#include <condition_variable>
#include <mutex>

namespace fulbito {

/// Turns of matches with teams outside the program, where more matches run at once than the machine has
/// cores: only so many play at a time, the others wait. So a team's wall time is its own, and no team is
/// late because others think.
class Turns {
 public:
  /// @param at_once  matches that play at a time, at least 1
  explicit Turns(int at_once) : free_(at_once) {}
  /// Waits for a turn.
  void take();
  /// Ends the turn.
  void give();

 private:
  std::mutex mutex_;
  std::condition_variable freed_;
  int free_;
};

/// A turn, for as long as this lives.
class Turn {
 public:
  explicit Turn(Turns& turns) : turns_(turns) { turns_.take(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  ~Turn() { turns_.give(); }

 private:
  Turns& turns_;
};

}  // namespace fulbito
