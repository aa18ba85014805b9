#include "bridge/wire/client_program.hpp"

namespace fulbito::wire {

bool ClientProgram::read(double seconds) {
  const bool runs = child_.receive(out_, seconds) != Child::Received::kClosed;
  errors_ += child_.takeErrors();
  log_.addLines(out_, !runs);
  log_.addLines(errors_, !runs);
  return runs;
}

ChildEnd ClientProgram::end() {
  ChildEnd end = child_.end();
  if (end.reason == kKilled) end.reason = "it has closed its standard output";
  errors_ += child_.takeErrors();
  log_.addLines(errors_, true);
  return end;
}

void ClientProgram::waitForEnd(int looks) {
  constexpr double kLook = 0.05;  // [s]
  child_.closeInput();
  for (int i = 0; i < looks && read(kLook); ++i) {
  }
}

}  // namespace fulbito::wire
