#include "replays/coding/columns.hpp"

#include <functional>
#include <limits>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr std::int32_t kHigh = 2147483000;  // the largest result of wholeSteps

Columns tableOf(std::size_t columns, std::size_t rows,
                const std::function<std::int32_t(std::size_t, std::size_t)>& at) {
  Columns table(columns, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    table.addRow();
    for (std::size_t column = 0; column < columns; ++column) table.at(column, row) = at(column, row);
  }
  return table;
}

/// The written bytes of a table, after a check that they read back as the same table.
Bytes written(const Columns& table, Trend trend) {
  Bytes bytes;
  writeColumns(table, trend, bytes);
  CHECK(bytes.size() <= mostColumnBytes(table.columns(), table.rows()));
  const auto back = readColumns(bytes, table.columns(), table.rows(), trend);
  REQUIRE(back);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < table.columns(); ++column) {
      REQUIRE(back->at(column, row) == table.at(column, row));
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("whole steps are the nearest, and nothing impossible is cast", "[unit]") {
  CHECK(wholeSteps(0.0149, 0.01) == 1);
  CHECK(wholeSteps(0.0151, 0.01) == 2);
  CHECK(wholeSteps(-0.0151, 0.01) == -2);
  CHECK(wholeSteps(46.08, 0.01) == 4608);
  CHECK(wholeSteps(1e30, 0.01) == 0);
  CHECK(wholeSteps(std::numeric_limits<double>::quiet_NaN(), 0.01) == 0);
  CHECK(wholeSteps(-std::numeric_limits<double>::infinity(), 0.01) == 0);
  // A value that was rounded to a multiple of the step reads back with the same bits.
  for (int i = -5000; i <= 5000; ++i) {
    const double rounded = static_cast<double>(i) * 0.01;
    REQUIRE(wholeSteps(rounded, 0.01) * 0.01 == rounded);
  }
}

TEST_CASE("tables come back, whatever is in them", "[unit]") {
  Rng rng(3, test::kTestStream);
  for (const Trend trend : {Trend::kStays, Trend::kGoesOn}) {
    written(tableOf(6, 300, [&](auto, auto) { return rng.below(2) == 0 ? kHigh : -kHigh; }), trend);
    written(tableOf(6, 300, [&](auto, auto) { return static_cast<std::int32_t>(rng.bits32()) / 2; }), trend);
    written(tableOf(2, 1, [](auto, auto) { return 7; }), trend);
    written(tableOf(0, 5, [](auto, auto) { return 0; }), trend);
  }
}

TEST_CASE("a value that is as expected takes a byte, and so do small multiples of a large unit", "[unit]") {
  const auto still = tableOf(2, 300, [](auto, auto) { return 1234567; });
  CHECK(written(still, Trend::kStays).size() == 2 * (3 + 300));
  const auto steady = tableOf(1, 300, [](auto, std::size_t row) { return 1 + 1000 * static_cast<int>(row); });
  CHECK(written(steady, Trend::kGoesOn).size() == 1 + 300 + 1);
  CHECK(written(steady, Trend::kStays).size() == 1 + 1 + 2 * 299);
  const auto coarse = tableOf(1, 300, [](auto, std::size_t row) { return 18 * static_cast<int>(row % 50); });
  CHECK(written(coarse, Trend::kStays).size() == 1 + 300);
}

TEST_CASE("what is no table of that size, or leaves the range of its values, is refused", "[unit]") {
  Rng rng(4, test::kTestStream);
  const auto table = tableOf(4, 50, [&](auto, auto) { return static_cast<std::int32_t>(rng.below(900)); });
  const Bytes bytes = written(table, Trend::kGoesOn);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    REQUIRE_FALSE(readColumns(bytes.substr(0, size), 4, 50, Trend::kGoesOn));
  }
  CHECK_FALSE(readColumns(bytes + "x", 4, 50, Trend::kGoesOn));
  const auto refused = [](std::uint64_t unit, std::int64_t value) {
    Bytes one;
    ByteWriter out(one);
    out.varint(unit);
    out.signedVarint(value);
    return !readColumns(one, 1, 1, Trend::kStays);
  };
  CHECK_FALSE(refused(3, 5));
  CHECK(refused(0, 5));
  CHECK(refused(3, 1000000000));
  CHECK(refused(1, std::numeric_limits<std::int64_t>::min()));
  CHECK(refused(1, std::numeric_limits<std::int64_t>::max()));
}

}  // namespace fulbito
