#include "engine/core/config/toml_reader.hpp"

#include <cstdlib>
#include <cstring>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("a document comes back in the order of the file with its lines", "[unit]") {
  const auto root = parseToml("z = 1\n\n[b]\ny = 0.5\nx = [true,\n 'text']\n[a]\nday = 2020-01-01\n", "f");
  REQUIRE(root);
  REQUIRE(root->entries.size() == 3);
  CHECK(root->entries[0].key == "z");
  CHECK(root->entries[1].key == "b");
  CHECK(root->entries[1].line == 3);
  const TomlTable& b = std::get<TomlTable>(root->entries[1].value.data);
  CHECK(b.entries[1].line == 5);
  const TomlArray& x = std::get<TomlArray>(b.find("x")->value.data);
  CHECK(std::get<bool>(x[0].data));
  CHECK(std::get<std::string>(x[1].data) == "text");
  CHECK(x[1].line == 6);
  CHECK(std::get<double>(b.find("y")->value.data) == 0.5);
  CHECK(b.find("nothing") == nullptr);
  CHECK(typeName(std::get<TomlTable>(root->find("a")->value.data).find("day")->value) == "a date or time");
}

TEST_CASE("text that is not TOML gives its line", "[unit]") {
  CHECK(parseToml("a = 1\nb = \n", "f.toml").error().message.starts_with("f.toml:2: not valid TOML: "));
  CHECK(parseToml("a = 1\n[t]\n[t]\n", "f").error().message ==
        "f:3: not valid TOML: Error while parsing table header: cannot redefine existing table 't'");
  CHECK(parseToml("a = 1\na = 2\n", "f").error().message.starts_with("f:2: not valid TOML: "));
  CHECK(parseToml("a = 1e999\n", "f").error().code == ErrorCode::kBadInput);
}

TEST_CASE("hostile text is refused in good order", "[unit]") {
  std::string dotted = "a";
  for (int i = 0; i < 100000; ++i) dotted += ".a";
  CHECK(parseToml("x = 1\n" + dotted + " = 1\n", "f").error().message ==
        "f:2: more than 4000 dots on one line");
  CHECK(parseToml("[" + dotted + "]\n", "f").error().message == "f:1: more than 4000 dots on one line");
  const std::string deep = dotted.substr(0, 7999);
  CHECK(parseToml("[" + deep + "]\n" + deep + " = 1\n", "f").error().message ==
        "f:1: 'a' is nested deeper than 16 levels");
  CHECK_FALSE(parseToml("a = " + std::string(100000, '[') + "\n", "f"));
  CHECK_FALSE(parseToml(std::string(100000, '['), "f"));
  CHECK(parseToml("a = " + std::string(20, '[') + std::string(20, ']'), "f").error().message ==
        "f:1: 'a' is nested deeper than 16 levels");
  CHECK(parseToml(std::string(kMaxTomlBytes + 1, '\n'), "f").error().message ==
        "f: larger than the limit of 1048576 bytes");
  CHECK(parseToml(std::string(kMaxTomlBytes, '\n'), "f"));
  CHECK(parseToml("[ ]", "f").error().message.starts_with("f:1: not valid TOML: "));
  CHECK(parseToml("a = [}", "f").error().message.starts_with("f:1: not valid TOML: "));
  std::string junk;
  for (int i = 0; i < 256; ++i) junk += static_cast<char>(i);
  CHECK(parseToml(junk, "f").error().message.starts_with("f:1: not valid TOML: "));
}

TEST_CASE("messages carry no control characters", "[unit]") {
  CHECK(printable("a\x1b[31m\xff") == "a\\x1b[31m\\xff");
  CHECK(printable("abcdef", 3) == "abc...");
  const auto root = parseToml("\x1b]0;title\x07 = 1", "f");
  REQUIRE_FALSE(root);
  for (char c : root.error().message) CHECK((c >= 0x20 && c < 0x7f));
}

TEST_CASE("every finite number is written so that the same bits come back", "[unit]") {
  CHECK(tomlNumber(9.0) == "9.0");
  CHECK(tomlNumber(-0.0) == "-0.0");
  CHECK(tomlNumber(0.1) == "0.1");
  CHECK(tomlNumber(1e300) == "1e+300");
  Rng rng(1, test::kTestStream);
  for (int i = 0; i < 2000; ++i) {
    const double value = (rng.uniform(-1.0, 1.0)) * (i % 2 == 0 ? 1.0 : 1e-200);
    const auto root = parseToml("v = " + tomlNumber(value), "f");
    REQUIRE(root);
    const double back = std::get<double>(root->find("v")->value.data);
    CHECK(std::memcmp(&back, &value, sizeof value) == 0);
  }
}

TEST_CASE("every string is written so that it comes back", "[unit]") {
  for (const std::string text : {"plain", "quo\"te", "back\\slash", "tab\tline\n", "caf\xc3\xa9"}) {
    const auto root = parseToml("v = " + tomlString(text), "f");
    REQUIRE(root);
    CHECK(std::get<std::string>(root->find("v")->value.data) == text);
  }
}

}  // namespace fulbito
