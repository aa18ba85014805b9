#pragma once

#include <condition_variable>
#include <mutex>

namespace fulbito {

/// Lets a limited number of matches play at a time. It is used for teams outside the program when more
/// matches run at once than the machine has cores. The others wait, so the computing time of other matches
/// makes no team late.
class Turns {
 public:
  /// @param at_once  largest number of matches that play at a time, at least 1
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

/// Holds a turn for the lifetime of this object.
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
