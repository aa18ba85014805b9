#include "tests/support/team_properties.hpp"

#include "fulbito/strategy.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("every built-in team keeps what teams promise", "[unit]") {
  for (const auto& info : TeamCatalogue::builtIn().teams()) {
    DYNAMIC_SECTION(info->name) {
      test::TeamProperties properties;
      // The team `random` draws from its own random stream, which does not depend on the side.
      properties.mirrored = info->name != "random";
      test::checkTeamProperties(info->name, properties);
    }
  }
}

}  // namespace fulbito
