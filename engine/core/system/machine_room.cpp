#include "engine/core/system/machine_room.hpp"

#include <algorithm>
#include <new>
#include <string>
#include <system_error>

#include "engine/core/system/shortage.hpp"

namespace fulbito {
namespace {

// The limit of tasks at once rises by one after this many successes per allowed task. So a lasting shortage
// costs few attempts, and a short one does not slow the rest of a long run.
constexpr int kPatience = 8;

}  // namespace

Error machineError() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return {ErrorCode::kMachine, "not enough memory"};
  } catch (const std::system_error& error) {
    if (!isShortage(error.code().value())) throw;
    return {ErrorCode::kMachine, error.what()};
  }
}

MachineRoom::Entry MachineRoom::enter() {
  std::unique_lock lock(mutex_);
  left_.wait(lock, [this] { return running_ < most_; });
  return {++entered_, ++running_};
}

bool MachineRoom::leave(const Entry& entry, bool failed) {
  const std::lock_guard lock(mutex_);
  const bool alone = entry.running == 1 && entry.number == entered_;
  if (failed && !alone) {
    most_ = std::min(most_, std::max(1, std::max(entry.running, running_) - 1));
    well_ = 0;
  } else if (!failed && most_ < std::numeric_limits<int>::max() && ++well_ >= kPatience * most_) {
    ++most_;
    well_ = 0;
  }
  --running_;
  left_.notify_all();
  return alone;
}

void MachineRoom::countRepeat() {
  const std::lock_guard lock(mutex_);
  ++repeated_;
}

std::size_t MachineRoom::repeated() const {
  const std::lock_guard lock(mutex_);
  return repeated_;
}

}  // namespace fulbito
