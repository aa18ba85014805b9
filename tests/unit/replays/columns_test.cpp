#include "replays/columns.hpp"

#include <limits>

#include "engine/core/random.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHigh = std::numeric_limits<std::int32_t>::max();

Columns tableOf(const std::vector<std::vector<std::int32_t>>& columns) {
  Columns table(columns.size(), columns.front().size() + 3);
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    table.addRow();
    for (std::size_t column = 0; column < columns.size(); ++column)
      table.at(column, row) = columns[column][row];
  }
  return table;
}

std::vector<std::int32_t> ramp(std::int32_t first, std::int32_t step, int count) {
  std::vector<std::int32_t> values;
  for (int i = 0; i < count; ++i) values.push_back(first + i * step);
  return values;
}

void checkRoundTrip(const Columns& table, std::size_t planes) {
  PackedColumns packed;
  packColumns(table, packed);
  CHECK(packed.ends.size() == planes);
  CHECK(packed.ends.back() == packed.bytes.size());
  CHECK(packed.bytes.size() == 1 + table.columns() + planes * table.columns() * table.rows());
  CHECK(packed.bytes.size() <= maxPackedSize(table.columns(), table.rows()));
  const auto back = unpackColumns(packed.bytes, table.columns(), table.rows());
  REQUIRE(back);
  for (std::size_t column = 0; column < table.columns(); ++column) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      REQUIRE(back->at(column, row) == table.at(column, row));
    }
  }
}

}  // namespace

TEST_CASE("columns come back, whatever they hold", "[unit]") {
  checkRoundTrip(tableOf({{0, 0, 0}, {5, -5, 127}}), 1);
  checkRoundTrip(tableOf({{kLow, kHigh, kLow, 0, -1, kHigh}, {1, 2, 3, 4, 5, 6}}), 4);
  Rng rng(3, Stream::kTest);
  std::vector<std::vector<std::int32_t>> noise(7);
  for (auto& column : noise) {
    for (int i = 0; i < 100; ++i) column.push_back(static_cast<std::int32_t>(rng.bits32()));
  }
  checkRoundTrip(tableOf(noise), 4);
}

TEST_CASE("a prediction takes away what is regular", "[unit]") {
  // Only the first two values of a line are a surprise, so one plane holds a ramp far beyond a byte.
  checkRoundTrip(tableOf({ramp(0, 90, 50)}), 1);
  checkRoundTrip(tableOf({std::vector<std::int32_t>(50, 100)}), 1);
  checkRoundTrip(tableOf({ramp(30000, 90, 50)}), 2);
}

TEST_CASE("bytes that are no such table are refused", "[unit]") {
  PackedColumns packed;
  packColumns(tableOf({{1, 2, 3}, {4, 5, 6}}), packed);
  const auto refuses = [](const Bytes& bytes, std::size_t columns, std::size_t rows) {
    return !unpackColumns(bytes, columns, rows).has_value();
  };
  CHECK_FALSE(refuses(packed.bytes, 2, 3));
  CHECK(refuses(packed.bytes, 2, 4));
  CHECK(refuses(packed.bytes, 3, 3));
  CHECK(refuses("", 2, 3));
  CHECK(refuses(packed.bytes + "x", 2, 3));
  for (const char planes : {'\0', '\5', '\xff'}) {
    Bytes bad = packed.bytes;
    bad[0] = planes;
    CHECK(refuses(bad, 2, 3));
  }
  Bytes bad = packed.bytes;
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
