#include "tournament/report/shown_text.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

TEST_CASE("shown text is one line without controls, direction marks and invalid bytes", "[unit]") {
  CHECK(shownText("libero", 10) == "libero");
  CHECK(shownText("a\nb\tc\x1b[31m", 20) == "a b c [31m");
  CHECK(shownText("a\xc2\x9b"
                  "31m",
                  20) == "a 31m");  // C1 control: a terminal's CSI
  CHECK(shownText("a\xe2\x80\xae"
                  "b\xe2\x81\xa6"
                  "c",
                  20) == "abc");  // right-to-left override, isolate
  CHECK(shownText("a\xff\xc0\xaf"
                  "b",
                  20) == "a   b");
  CHECK(shownText("a\xe2\x80\xa8"
                  "b",
                  20) == "a b");  // line separator
  CHECK(shownText("", 5).empty());
}

TEST_CASE("shown text takes at most its columns and says that it goes on", "[unit]") {
  CHECK(shownText("libero", 6) == "libero");
  CHECK(shownText("libero!", 6) == "liber…");
  CHECK(shownText("球球球", 6) == "球球球");
  CHECK(shownText("球球球球", 6) == "球球…");
  CHECK(shownText("a\xe2\x80\xae", 1) == "a");
  const std::string marks = "e" + [] {
    std::string all;
    for (int i = 0; i < 5000; ++i) all += "\xcc\x81";
    return all;
  }();
  CHECK(columnsOf(shownText(marks, 40)) == 40);
  for (int columns = 1; columns < 12; ++columns) {
    CHECK(columnsOf(shownText("ab球c球dé😀xyz", columns)) <= columns);
  }
}

TEST_CASE("padding counts columns, not bytes", "[unit]") {
  CHECK(padded("é", 3, false) == "é  ");
  CHECK(padded("球", 3, true) == " 球");
  CHECK(padded("long", 2, true) == "long");
  CHECK(columnsOf("球a") == 3);
}
