#include "engine/core/system/error_text.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("what could change a terminal is shown as text", "[unit]") {
  CHECK(terminalText("a\tb\nc") == "a\tb\nc");
  CHECK(terminalText("\x1b]0;owned\x07") == "\\x1b]0;owned\\x07");
  CHECK(terminalText("del\x7f") == "del\\x7f");
  CHECK(terminalText("\xc2\x9b"
                     "31m") == "\\u009b31m");  // CSI in one character
  CHECK(terminalText("\xe2\x80\xae"
                     "x") == "\\u202ex");  // writes to the left
  CHECK(terminalText("né \xe2\x80\x93 ✓ 🙂") == "né \xe2\x80\x93 ✓ 🙂");
  CHECK(terminalText("\xff"
                     "a\xc3") == "\\xffa\\xc3");             // no UTF-8
  CHECK(terminalText("\xc0\x9b") == "\\xc0\\x9b");           // longer than allowed
  CHECK(terminalText("\xed\xa0\x80") == "\\xed\\xa0\\x80");  // half of a pair
}

TEST_CASE("a text is cut between characters", "[unit]") {
  CHECK(firstBytes("aéé", 4) == "aé");
  CHECK(firstBytes("aéé", 5) == "aéé");
  std::string text;
  for (int i = 0; i < 200; ++i) text += "é";
  const std::string cut = shortened(text, 101);
  CHECK(cut.size() < 150);
  CHECK(terminalText(cut) == cut);
  CHECK(cut.find("bytes omitted") != std::string::npos);
  CHECK(shortened("short", 100) == "short");
}

TEST_CASE("an error names its file once", "[unit]") {
  const Error error{ErrorCode::kBadInput, "the chunk is bad"};
  const auto named = inFile("a.fbr", error);
  CHECK(named.value().message == "a.fbr: the chunk is bad");
  CHECK(inFile("a.fbr", named.value()).value().message == "a.fbr: the chunk is bad");
}

}  // namespace fulbito
