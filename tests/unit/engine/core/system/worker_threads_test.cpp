#include "engine/core/system/worker_threads.hpp"

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// Runs `check` in a process that may start no thread. @return its result
template <typename Check>
bool withoutThreads(const Check& check) {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::alarm(20);  // an endless wait fails the test
    const rlimit none{0, 0};
    // The limit does not apply to root.
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
    std::vector<int> done(20, 0);
    std::vector<std::size_t> heard;
    WorkProgress progress(
        [&](std::size_t tasks, std::size_t total) {
          heard.push_back(tasks);
          return total == 20;
        },
        done.size());
    REQUIRE(parallelFor(jobs, done.size(), progress, [&](std::size_t i) -> Result<void> {
      ++done[i];
      return {};
    }));
    CHECK(done == std::vector<int>(20, 1));
    std::vector<std::size_t> counted(20);
    std::iota(counted.begin(), counted.end(), 1);
    CHECK(heard == counted);
  }
  CHECK(threadsFor(8, 3) == 3);
  CHECK(threadsFor(8, 0) == 1);
  CHECK(threadsFor(0, 1000) >= 1);
}

TEST_CASE("the error is that of the first failed task, whatever the number of threads", "[unit]") {
  for (const int jobs : {1, 2, 8}) {
    for (int round = 0; round < 20; ++round) {
      WorkProgress progress({}, 100);
      std::atomic<int> done{0};
      const auto result = parallelFor(jobs, 100, progress, [&](std::size_t i) -> Result<void> {
        // The failing task with the lowest number takes longest.
        if (i == 20) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        if (i >= 20 && i % 2 == 0) return fail(ErrorCode::kBadInput, std::to_string(i));
        ++done;
        return {};
      });
      REQUIRE_FALSE(result);
      REQUIRE(result.error().message == "20");
      CHECK(done < 99);
    }
  }
}

TEST_CASE("a task that was broken off hides no error of another", "[unit]") {
  WorkProgress progress({}, 2);
  std::atomic<bool> failed{false};
  const auto result = parallelFor(2, 2, progress, [&](std::size_t i) -> Result<void> {
    if (i == 1) {
      failed = true;
      return fail(ErrorCode::kIo, "disk full");
    }
    for (int wait = 0; wait < 2000 && !failed; ++wait)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return fail(ErrorCode::kInterrupted, "interrupted");
  });
  REQUIRE_FALSE(result);
  CHECK(result.error().code == ErrorCode::kIo);
}

TEST_CASE("a watcher stops the work, and the loops after it", "[unit]") {
  std::atomic<int> done{0};
  const auto count = [&done](std::size_t) -> Result<void> {
    ++done;
    return {};
  };
  WorkProgress progress([](std::size_t tasks, std::size_t) { return tasks < 10; }, 200000);
  const auto stopped = parallelFor(2, 100000, progress, count);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
  CHECK(done < 100000);
  CHECK_FALSE(progress.goesOn());
  const int before = done;
  CHECK_FALSE(parallelFor(2, 100000, progress, count));
  CHECK(done == before);
  // After the last task there is nothing left to stop.
  WorkProgress last([](std::size_t tasks, std::size_t total) { return tasks < total; }, 7);
  CHECK(parallelFor(2, 7, last, count));
}

TEST_CASE("an exception ends the work and comes out of it", "[unit]") {
  std::atomic<int> done{0};
  WorkProgress progress({}, 100000);
  CHECK_THROWS_AS(parallelFor(2, 100000, progress,
                              [&](std::size_t i) -> Result<void> {
                                if (i == 5) throw std::bad_alloc();
                                ++done;
                                return {};
                              }),
                  std::bad_alloc);
  CHECK(done < 100000);
}

TEST_CASE("where no thread can be started the caller's does the work", "[unit]") {
  CHECK(withoutThreads([] {
    int done = 0;
    WorkProgress progress({}, 30);
    const auto result = parallelFor(8, 30, progress, [&](std::size_t) -> Result<void> {
      ++done;
      return {};
    });
    int running = -1;
    runBeside(8, [] {}, [&](int threads) { running = threads; });
    return result && done == 30 && running == 0;
  }));
}

}  // namespace fulbito
