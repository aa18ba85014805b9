#include "engine/core/system/stop_request.hpp"

#include <atomic>

namespace fulbito {
namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // as a signal handler needs it

}  // namespace

void requestStop() noexcept { requested.store(true, std::memory_order_relaxed); }
bool stopRequested() noexcept { return requested.load(std::memory_order_relaxed); }

}  // namespace fulbito
