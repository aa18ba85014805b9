#include "python/environments/worker_pool.hpp"

#include <csignal>
#include <immintrin.h>
#include <new>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace fulbito {
namespace {

constexpr int kBits = 20;  // of a task's number
constexpr std::uint64_t kMask = WorkerPool::kMostTasks;
// Turns of a wait before the thread sleeps: about as long as waking it takes.
constexpr int kSpins = 2000;

template <typename Word, typename Done>
void await(const std::atomic<Word>& word, const Done& done) {
  for (int i = 0; i < kSpins; ++i) {
    if (done(word.load(std::memory_order_acquire))) return;
    _mm_pause();
  }
  for (Word now = word.load(std::memory_order_acquire); !done(now);
       now = word.load(std::memory_order_acquire)) {
    word.wait(now, std::memory_order_acquire);
  }
}

}  // namespace

WorkerPool::WorkerPool(int threads) : process_(getpid()) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  threads_.reserve(static_cast<std::size_t>(threads));
  for (int i = 1; i < threads; ++i) {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {  // no process left: fewer threads do the work
      break;
    }
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

WorkerPool::~WorkerPool() {
  if (forked()) {
    // The child does not have these threads, so nothing can be joined: their handles stay.
    (void)new (std::nothrow) std::vector<std::thread>(std::move(threads_));
    return;
  }
  stop_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

bool WorkerPool::forked() const { return getpid() != process_; }

void WorkerPool::start(std::size_t count, void (*task)(void*, std::size_t), void* context) {
  count_ = static_cast<std::uint32_t>(count);
  task_ = task;
  context_ = context;
  done_.store(0, std::memory_order_relaxed);
  const std::uint32_t round = round_.load(std::memory_order_relaxed) + 1;
  ticket_.store(std::uint64_t{round} << (2 * kBits) | std::uint64_t{count} << kBits,
                std::memory_order_release);
  round_.store(round, std::memory_order_release);
  if (count > 1 && !threads_.empty()) round_.notify_all();
}

bool WorkerPool::doOne() {
  std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
  std::uint64_t i = 0;
  do {
    i = ticket & kMask;
    if (i >= (ticket >> kBits & kMask)) return false;
  } while (!ticket_.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel));
  const std::uint32_t count = count_;  // the next round may begin once the last task is counted
  task_(context_, i);
  if (done_.fetch_add(1, std::memory_order_acq_rel) + 1 == count) done_.notify_one();
  return true;
}

void WorkerPool::work() {
  std::uint32_t seen = 0;
  while (true) {
    await(round_, [seen](std::uint32_t round) { return round != seen; });
    if (stop_) return;
    seen = round_.load(std::memory_order_acquire);
    while (doOne()) {
    }
  }
}

void WorkerPool::finish() {
  while (doOne()) {
  }
  await(done_, [this](std::uint32_t done) { return done >= count_; });
}

}  // namespace fulbito
