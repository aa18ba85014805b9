#include "replays/coding/columns.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace fulbito {
namespace {

/// The greatest common divisor of all values of a column; 1 if all are 0.
std::int32_t unitOf(const Columns& table, std::size_t column) {
  std::int32_t unit = 0;
  for (std::size_t row = 0; row < table.rows() && unit != 1; ++row) {
    unit = std::gcd(unit, table.at(column, row));
  }
  return std::max(unit, 1);
}

}  // namespace

void writeColumns(const Columns& table, Trend trend, Bytes& bytes) {
  ByteWriter out(bytes);
  for (std::size_t column = 0; column < table.columns(); ++column) {
    const std::int32_t unit = unitOf(table, column);
    out.varint(static_cast<std::uint64_t>(unit));
    ColumnPredictor predictor;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::int64_t value = table.at(column, row) / unit;
      const Trend now = row == 0 ? Trend::kStays : trend;
      out.signedVarint(value - predictor.predicted(now));
      predictor.learn(value, now);
    }
  }
}

std::optional<Columns> readColumns(BytesView bytes, std::size_t columns, std::size_t rows, Trend trend) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  ByteReader in(bytes);
  Columns table(columns, rows);
  for (std::size_t row = 0; row < rows; ++row) table.addRow();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto unit = static_cast<std::int64_t>(in.varint(kMost));
    if (unit == 0) return std::nullopt;
    ColumnPredictor predictor;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::int64_t difference = in.signedVarint();
      if (difference < -4 * kMost || difference > 4 * kMost) return std::nullopt;
      const Trend now = row == 0 ? Trend::kStays : trend;
      const std::int64_t value = predictor.predicted(now) + difference;
      if (std::abs(value) > kMost / unit) return std::nullopt;
      predictor.learn(value, now);
      table.at(column, row) = static_cast<std::int32_t>(value * unit);
    }
  }
  if (!in.good() || !in.atEnd()) return std::nullopt;
  return table;
}

}  // namespace fulbito
