#include "engine/core/system/machine_room.hpp"

#include <atomic>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "engine/core/system/worker_threads.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

using Task = Result<int>;

Task lacking() { return fail(ErrorCode::kMachine, "no process is left"); }

}  // namespace

TEST_CASE("a task that the machine fails is run again, a bounded number of times", "[unit]") {
  MachineRoom room(2);
  int attempts = 0;
  const auto third = room.run([&]() -> Task { return ++attempts < 3 ? lacking() : Task(7); });
  REQUIRE(third);
  CHECK(*third == 7);
  CHECK(room.repeated() == 2);
  attempts = 0;
  const auto never = room.run([&]() -> Task {
    ++attempts;
    return lacking();
  });
  REQUIRE_FALSE(never);
  CHECK(never.error().message == "no process is left");
  CHECK(attempts == 3);
  attempts = 0;
  const auto other = room.run([&]() -> Task {
    ++attempts;
    return fail(ErrorCode::kBadInput, "wrong");
  });
  CHECK(other.error().code == ErrorCode::kBadInput);
  CHECK(attempts == 1);
}

TEST_CASE("exceptions that say that the machine lacks something are its failures", "[unit]") {
  MachineRoom room(0);
  const auto memory = room.run([]() -> Task { throw std::bad_alloc(); });
  CHECK(memory.error().code == ErrorCode::kMachine);
  const auto thread = room.run([]() -> Task {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  });
  CHECK(thread.error().code == ErrorCode::kMachine);
  CHECK_THROWS_AS(room.run([]() -> Task { throw std::logic_error("a bug"); }), std::logic_error);
  CHECK_THROWS_AS(room.run([]() -> Task {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory));
  }),
                  std::system_error);
}

TEST_CASE("of tasks that do not fit beside each other, fewer run at once", "[unit]") {
  for (const int space : {1, 2, 5}) {
    INFO(space);
    MachineRoom room(2);
    std::atomic<int> running{0}, done{0};
    WorkProgress progress({}, 60);
    const auto all = parallelFor(8, 60, progress, [&](std::size_t) -> Result<void> {
      const auto result = room.run([&]() -> Task {
        const bool fits = ++running <= space;
        for (int i = 0; i < 200; ++i) std::this_thread::yield();
        --running;
        return fits ? Task(1) : lacking();
      });
      if (!result) return tl::unexpected<Error>(result.error());
      ++done;
      return {};
    });
    REQUIRE(all);
    CHECK(done == 60);
  }
}

}  // namespace fulbito
