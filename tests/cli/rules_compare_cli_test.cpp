#include <nlohmann/json.hpp>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("rules compare lists by rule where two profiles differ on recordings", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 30 --seed 4 --record one.fbr");
  box.works("match chaser chaser --half-seconds 30 --seed 5 --record two.fbr");
  const Output table = box.run("rules compare vsss-3v3 league-program-2021 one.fbr two.fbr --list");
  CHECK(table.code == 0);
  CHECK(contains(table.out, "A = vsss-3v3, B = league-program-2021"));
  CHECK(contains(table.out, "2 recordings, "));

  const Output object = box.run("rules compare vsss-3v3 league-program-2021 one.fbr two.fbr --json");
  CHECK(object.code == 0);
  const auto json = nlohmann::json::parse(object.out);
  CHECK(json["schema_version"] == 1);
  CHECK(json["files"] == 2);
  CHECK(json["as_recorded"][0] == json["plays"]);
  CHECK_FALSE(json["rules"].empty());
  const auto same = nlohmann::json::parse(box.run("rules compare vsss-3v3 vsss-3v3 one.fbr --json").out);
  CHECK(same["agreement"]["same"] == same["plays"]);
}

TEST_CASE("rules compare refuses what is no recording, with the exit code of its kind", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 5 --record one.fbr");
  CHECK(box.run("rules compare vsss-3v3 vsss-3v3").code == 2);
  CHECK(box.run("rules compare vsss-3v3 vss-3v3 one.fbr").code == 2);
  CHECK(box.run("rules compare vsss-3v3 vsss-3v3 none.fbr").code == 5);
  const Output wrong = box.run("rules compare vsss-3v3 vsss-3v3 " FULBITO_PROGRAM);
  CHECK(wrong.code == 3);
  CHECK(contains(wrong.err, "not a recording"));
  CHECK(wrong.out.empty());
}
