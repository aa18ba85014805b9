#include "bridge/outside/bounded_log.hpp"

#include <string>
#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("of a match's standard error the first MiB is shown, and how much followed", "[unit]") {
  std::vector<std::string> shown;
  BoundedLog log([&](std::string_view line) { shown.emplace_back(line); });
  const std::string line(1023, 'x');
  for (int i = 0; i < 1024; ++i) log.add(line);
  REQUIRE(shown.size() == 1024);
  for (const char* more : {"a", "bc"}) log.add(more);
  CHECK(shown.size() == 1024);
  log.finish();
  REQUIRE(shown.size() == 1025);
  CHECK(shown.back() == "[5 more bytes of standard error in this match]");
  log.finish();
  log.add("the next match");
  CHECK(shown.back() == "the next match");
  CHECK(shown.size() == 1026);
}

TEST_CASE("a line beyond the bound leaves out all that follows", "[unit]") {
  std::vector<std::string> shown;
  {
    BoundedLog log([&](std::string_view line) { shown.emplace_back(line); });
    log.add("short");
    log.add(std::string(BoundedLog::kMost, 'x'));
    log.add("short");
  }
  REQUIRE(shown.size() == 2);
  CHECK(shown.back() == "[1048583 more bytes of standard error in this match]");
  BoundedLog nobody{TeamLog{}};
  nobody.add(std::string(BoundedLog::kMost, 'x'));
}

}  // namespace fulbito
