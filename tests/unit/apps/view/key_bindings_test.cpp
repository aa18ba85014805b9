#include "apps/view/key_bindings.hpp"

#include <algorithm>
#include <set>

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("every key does something, and every action has a key", "[unit]") {
  std::set<ViewAction> actions;
  for (int key = 0; key <= static_cast<int>(ViewKey::kT); ++key) {
    for (const bool shift : {false, true}) {
      const auto action = actionOf({static_cast<ViewKey>(key), shift});
      INFO(key);
      REQUIRE(action);
      actions.insert(*action);
    }
  }
  CHECK(actions.size() == static_cast<std::size_t>(ViewAction::kQuit) + 1);
}

TEST_CASE("shift makes ten seconds of one", "[unit]") {
  CHECK(actionOf({ViewKey::kLeft, false}) == ViewAction::kSecondBack);
  CHECK(actionOf({ViewKey::kLeft, true}) == ViewAction::kTenBack);
  CHECK(actionOf({ViewKey::kRight, true}) == ViewAction::kTenOn);
  CHECK(actionOf({ViewKey::kSpace, true}) == ViewAction::kPlay);
}

TEST_CASE("the help tells of seeking only where one can, and of dragging only where one may", "[unit]") {
  int replay = 0, live = 0;
  for (const KeyHelp& row : keyHelp()) {
    CHECK_FALSE(row.keys.empty());
    CHECK_FALSE(row.text.empty());
    CHECK((row.replay || row.live));
    replay += row.replay && !row.live ? 1 : 0;
    live += row.live && !row.replay ? 1 : 0;
  }
  const auto closes = [](const KeyHelp& row) {
    return row.keys == "Q, Esc" && row.text.starts_with("close this list");
  };
  CHECK(std::any_of(keyHelp().begin(), keyHelp().end(), closes));
  CHECK(replay > 0);
  CHECK(live > 0);
}

}  // namespace fulbito
