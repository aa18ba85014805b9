#include "tournament/folder/json_changes.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;
using Changes = std::vector<std::string>;

}  // namespace

TEST_CASE("equal JSON has no changes, whatever the order of its members", "[unit]") {
  CHECK(changesOf(Json::parse(R"({"a": 1, "b": [1, 2]})"), Json::parse(R"({"b": [1, 2], "a": 1})")).empty());
}

TEST_CASE("values that differ are named by their path, members of arrays from 1", "[unit]") {
  const auto changes = [](const char* before, const char* after) {
    return changesOf(Json::parse(before), Json::parse(after));
  };
  CHECK(changes(R"({"a": {"b": 1}})", R"({"a": {"b": 2.5}})") == Changes{"a.b: 1 -> 2.5"});
  CHECK(changes(R"({"a": "x"})", R"({"a": "y"})") == Changes{"a: x -> y"});
  CHECK(changes(R"({"a": [1, 2]})", R"({"a": [1, 3, 4]})") == Changes{"a.2: 2 -> 3", "a.3: none -> 4"});
  CHECK(changes(R"({"a": 1, "b": 2})", R"({"b": 2})") == Changes{"a: 1 -> none"});
}

TEST_CASE("texts in TOML are compared key by key", "[unit]") {
  const Json before{{"robot", "mass = 0.2  # [kg]\n[wheel]\nradius = 0.02\n"}};
  const Json after{{"robot", "mass = 0.3  # [kg]\n[wheel]\nradius = 0.02\n"}};
  CHECK(changesOf(before, after) == Changes{"robot mass: 0.2 -> 0.3"});
}

}  // namespace fulbito
