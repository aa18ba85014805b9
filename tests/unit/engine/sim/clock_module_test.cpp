#include <dlfcn.h>

#include "tests/support/catch.hpp"

// The program itself links neither the engine nor Box2D: what the module brings must be enough.
TEST_CASE("Box2D's clock is out of a module that hides its symbols and is loaded at run time", "[unit]") {
  void* module = dlopen(FULBITO_CLOCK_MODULE, RTLD_NOW | RTLD_LOCAL);
  REQUIRE(module != nullptr);
  const auto milliseconds = reinterpret_cast<float (*)()>(dlsym(module, "moduleStepMilliseconds"));
  REQUIRE(milliseconds != nullptr);
  CHECK(milliseconds() == 0.0f);
}
