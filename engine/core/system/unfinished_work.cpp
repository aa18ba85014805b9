#include "engine/core/system/unfinished_work.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <unistd.h>

#include <climits>

namespace fulbito {
namespace {

constexpr int kMostFiles = 64;  // files at a time: each job writes one
constexpr int kNone = -1;

/// Fixed memory, since a signal handler must not lock or allocate.
struct Slot {
  enum State : int { kFree, kFilling, kListed };
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> name{};
};

std::array<Slot, kMostFiles> slots;
std::atomic<pid_t> helper{0};
static_assert(std::atomic<int>::is_always_lock_free);
static_assert(std::atomic<pid_t>::is_always_lock_free);

}  // namespace

TemporaryName::TemporaryName(const std::string& file) : slot_(kNone) {
  if (file.size() >= PATH_MAX) return;
  for (int i = 0; i < kMostFiles; ++i) {
    Slot& slot = slots[static_cast<std::size_t>(i)];
    int expected = Slot::kFree;
    if (!slot.state.compare_exchange_strong(expected, Slot::kFilling)) continue;
    std::memcpy(slot.name.data(), file.c_str(), file.size() + 1);
    slot.state = Slot::kListed;
    slot_ = i;
    return;
  }
}

TemporaryName::~TemporaryName() {
  if (slot_ != kNone) slots[static_cast<std::size_t>(slot_)].state = Slot::kFree;
}

void setHelperProcess(pid_t process) noexcept { helper = process; }

void abandonUnfinishedWork() noexcept {
  // The helper process ends first, since it could create its file again.
  if (const pid_t process = helper; process > 0) ::kill(process, SIGKILL);
  for (Slot& slot : slots) {
    if (slot.state == Slot::kListed) ::unlink(slot.name.data());
  }
}

}  // namespace fulbito
