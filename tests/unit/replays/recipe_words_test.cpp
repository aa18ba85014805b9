#include "replays/recording/recipe_words.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

using Words = std::vector<std::pair<std::string, std::string>>;

TEST_CASE("a team outside the program has the name that it gives itself", "[unit]") {
  RecordingRecipe recipe;
  CHECK(teamNames(recipe).empty());
  recipe.teams = {"cmd:python3 /home/me/team.py", "classic"};
  CHECK(teamNames(recipe) == recipe.teams);
  recipe.more = {{"blue_team_hash", "0123"}, {"blue_team_name", "Rovers"}};
  CHECK(teamNames(recipe) == std::vector<std::string>{"Rovers", "classic"});
}

TEST_CASE("vision is told once if it is the same for all, and not at all if it is perfect", "[unit]") {
  RecordingRecipe recipe;
  CHECK(visionWords(recipe).empty());
  recipe.vision = {{}, {}};
  CHECK(visionWords(recipe).empty());
  recipe.vision = {{3, 0.002, 0.0, 0.05}, {3, 0.002, 0.0, 0.05}};
  CHECK(visionWords(recipe) == Words{{"Vision", "latency 3 ticks, noise 2 mm and 0\u00b0, 5 % not seen"}});
  recipe.vision[1] = {};
  CHECK(visionWords(recipe) ==
        Words{{"Blue's vision", "latency 3 ticks, noise 2 mm and 0\u00b0, 5 % not seen"},
              {"Yellow's vision", "latency 0 ticks, noise 0 mm and 0\u00b0, 0 % not seen"}});
  recipe.vision.resize(1);
  CHECK(visionWords(recipe).size() == 1);
}
