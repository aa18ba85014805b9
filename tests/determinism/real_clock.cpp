// Linked into a second hash program: Box2D's profiling clock, really read. With these here the library's own
// object that leaves the clock out is not taken; the hashes must stay the same.
#include <chrono>
#include <cstdlib>

#include <box2d/b2_timer.h>

#include "engine/sim/engine_clock.hpp"

namespace {

unsigned long long nowMicroseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<unsigned long long>(std::chrono::duration_cast<std::chrono::microseconds>(now).count());
}

// Ends the program with an error if Box2D never asked for the time: then this file proves nothing.
struct Readings {
  long count = 0;
  ~Readings() {
    if (count == 0) std::abort();
  }
} readings;

}  // namespace

b2Timer::b2Timer() : m_start_sec(0), m_start_usec(nowMicroseconds()) {}
void b2Timer::Reset() { m_start_usec = nowMicroseconds(); }
float b2Timer::GetMilliseconds() const {
  ++readings.count;
  return static_cast<float>(nowMicroseconds() - m_start_usec) / 1000.0f;
}

namespace fulbito {

void keepEngineClockOut() {}

}  // namespace fulbito
