#include "bridge/process/child.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/malloc_counter.hpp"

namespace fulbito {

TEST_CASE("a warm conversation with a child allocates nothing", "[unit]") {
  ChildOptions options;
  options.command = {"cat"};
  Result<Child> child = Child::launch(options);
  REQUIRE(child);
  const std::string request(2000, 'x');
  std::string answer;
  const auto talk = [&] {
    answer.clear();
    bool well = child->send(request);
    while (well && answer.size() < request.size())
      well = child->receive(answer, 20.0) == Child::Received::kBytes;
    return well;
  };
  for (int k = 0; k < 10; ++k) REQUIRE(talk());
  const long before = test::mallocCount();
  int well = 0;
  for (int k = 0; k < 1000; ++k) well += talk() ? 1 : 0;
  CHECK(test::mallocCount() == before);
  CHECK(well == 1000);
}

}  // namespace fulbito
