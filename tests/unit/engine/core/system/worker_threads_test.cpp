#include "engine/core/system/worker_threads.hpp"

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// Runs `check` in a process that may start no thread; gives whether it held.
template <typename Check>
bool withoutThreads(const Check& check) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::alarm(20);  // a wait for ever is a failure
    const rlimit none{0, 0};
    // The limit does not hold for root.
    const bool limited = ::setrlimit(RLIMIT_NPROC, &none) == 0 && (::geteuid() != 0 || ::setuid(65534) == 0);
    ::_exit(limited && check() ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("each task is done once, whatever the number of threads", "[unit]") {
  for (const int jobs : {0, 1, 3, 50}) {
    std::vector<std::atomic<int>> done(20);
    forEachTask(jobs, done.size(), [&](std::size_t i) {
      ++done[i];
      return true;
    });
    for (const auto& times : done) CHECK(times == 1);
  }
  CHECK(threadsFor(8, 3) == 3);
  CHECK(threadsFor(8, 0) == 1);
  CHECK(threadsFor(0, 1000) >= 1);
}

TEST_CASE("tasks end early when one says so or throws", "[unit]") {
  std::atomic<int> done{0};
  forEachTask(2, 100000, [&](std::size_t) { return ++done < 10; });
  CHECK(done < 100000);
  done = 0;
  CHECK_THROWS_AS(forEachTask(2, 100000,
                              [&](std::size_t i) -> bool {
                                if (i == 5) throw std::bad_alloc();
                                ++done;
                                return true;
                              }),
                  std::bad_alloc);
  CHECK(done < 100000);
}

TEST_CASE("where no thread can be started the caller's does the work", "[unit]") {
  CHECK(withoutThreads([] {
    int done = 0;
    forEachTask(8, 30, [&](std::size_t) {
      ++done;
      return true;
    });
    int running = -1;
    runBeside(8, [] {}, [&](int threads) { running = threads; });
    return done == 30 && running == 0;
  }));
}

}  // namespace fulbito
