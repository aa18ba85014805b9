#include "engine/core/base/text_controls.hpp"

#include <nlohmann/json.hpp>

#include "engine/core/base/xml_text.hpp"
#include "engine/core/system/error_text.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// UTF-8 of a code point below 0x10000.
std::string utf8Of(std::uint32_t code) {
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 0x3f))};
  return {static_cast<char>(0xe0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3f)),
          static_cast<char>(0x80 | (code & 0x3f))};
}

bool steered(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = characterAt(text, i);
    if (c.size == 0 || steersText(c.code)) return true;
    i += c.size;
  }
  return false;
}

}  // namespace

TEST_CASE("no exit of a text lets through what steers it, of all characters of two bytes and more",
          "[unit]") {
  int steering = 0;
  for (std::uint32_t code = 0; code < 0x3000; ++code) {
    const std::string text = "a" + utf8Of(code) + "b";
    INFO("U+" << std::hex << code);
    if (!steersText(code)) {
      CHECK(oneLine(text) == text);
      continue;
    }
    ++steering;
    CHECK(oneLine(text) == "a b");
    CHECK_FALSE(steered(escapedXml(text)));
    CHECK_FALSE(steered(csvField(text)));
    const std::string json = escapedJson(nlohmann::json(text).dump());
    CHECK_FALSE(steered(json));
    CHECK(nlohmann::json::parse(json) == text);
    if (code != '\n' && code != '\t') CHECK_FALSE(steered(terminalText(text)));
  }
  CHECK(steering == 32 + 33 + 2 + 5 + 4);
}

TEST_CASE("what is no UTF-8 is one line as well", "[unit]") {
  CHECK(oneLine("a\xff\xc0z\xe2\x80") == "a  z  ");
  CHECK(escapedJson("\"\xff\"") == "\"\xff\"");
  CHECK(escapedJson("{\n  \"a\": \"\xc3\xa9\"\n}\n") == "{\n  \"a\": \"\xc3\xa9\"\n}\n");
}

TEST_CASE("a field of a CSV file is no formula and stays one field", "[unit]") {
  CHECK(csvField("libero") == "\"libero\"");
  CHECK(csvField("a,\"b\"\nc") == "\"a,\"\"b\"\" c\"");
  for (const char* formula : {"=1+1", "+1", "-1", "@sum(a1)", "\t=1", "\r=1"}) {
    CHECK(csvField(formula).starts_with("\"'"));
  }
  CHECK(csvField("") == "\"\"");
  CHECK(csvField("a=1") == "\"a=1\"");
}

}  // namespace fulbito
