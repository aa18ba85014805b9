#include "replays/coding/columns.hpp"

#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

/// Two columns of three rows in one plane: 1 2 3 by steps from the last value, 4 5 6 along a line.
const Bytes kTable{
    "\1\1\2"
    "\2\2\2"
    "\x08\x05\0",
    9};

}  // namespace

TEST_CASE("a table of version 1 is read", "[unit]") {
  const auto table = unpackColumns(kTable, 2, 3);
  REQUIRE(table);
  const std::vector<std::vector<std::int32_t>> expected{{1, 2, 3}, {4, 5, 6}};
  for (std::size_t column = 0; column < 2; ++column) {
    for (std::size_t row = 0; row < 3; ++row) CHECK(table->at(column, row) == expected[column][row]);
  }
  // The second plane holds the next eight bits of what is left.
  const auto wide = unpackColumns(Bytes("\2\0\x02\x01", 4), 1, 1);
  REQUIRE(wide);
  CHECK(wide->at(0, 0) == 129);
}

TEST_CASE("bytes that are no such table are refused", "[unit]") {
  const auto refuses = [](const Bytes& bytes, std::size_t columns, std::size_t rows) {
    return !unpackColumns(bytes, columns, rows).has_value();
  };
  CHECK_FALSE(refuses(kTable, 2, 3));
  CHECK(refuses(kTable, 2, 4));
  CHECK(refuses(kTable, 3, 3));
  CHECK(refuses("", 2, 3));
  CHECK(refuses(kTable + "x", 2, 3));
  for (const char planes : {'\0', '\5', '\xff'}) {
    Bytes bad = kTable;
    bad[0] = planes;
    CHECK(refuses(bad, 2, 3));
  }
  Bytes bad = kTable;
  bad[2] = '\3';  // no such predictor
  CHECK(refuses(bad, 2, 3));
}

TEST_CASE("whole steps are the nearest, and nothing impossible is cast", "[unit]") {
  CHECK(wholeSteps(0.0149, 0.01) == 1);
  CHECK(wholeSteps(0.0151, 0.01) == 2);
  CHECK(wholeSteps(-0.0151, 0.01) == -2);
  CHECK(wholeSteps(46.08, 0.01) == 4608);
  CHECK(wholeSteps(1e30, 0.01) == 0);
  CHECK(wholeSteps(std::numeric_limits<double>::quiet_NaN(), 0.01) == 0);
  CHECK(wholeSteps(-std::numeric_limits<double>::infinity(), 0.01) == 0);
  // What was rounded to the step comes back to the same bits.
  for (int i = -5000; i <= 5000; ++i) {
    const double rounded = static_cast<double>(i) * 0.01;
    REQUIRE(wholeSteps(rounded, 0.01) * 0.01 == rounded);
  }
}

}  // namespace fulbito
