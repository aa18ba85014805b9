#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "replays/coding/byte_io.hpp"

namespace fulbito {

/// A table of whole numbers, stored column by column; each column is one quantity over time.
class Columns {
 public:
  Columns() = default;
  Columns(std::size_t columns, std::size_t capacity) : columns_(columns), capacity_(capacity) {
    values_.resize(columns * capacity);
  }

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  void clear() { rows_ = 0; }
  /// Adds a row. The caller must set all its values.
  std::size_t addRow() { return rows_++; }
  std::int32_t& at(std::size_t column, std::size_t row) { return values_[column * capacity_ + row]; }
  std::int32_t at(std::size_t column, std::size_t row) const { return values_[column * capacity_ + row]; }

 private:
  std::size_t columns_ = 0, capacity_ = 0, rows_ = 0;
  std::vector<std::int32_t> values_;
};

/// How the next value of a column is predicted.
enum class Trend : std::uint8_t {
  kStays,  ///< the last value again
  kGoesOn  ///< the last value plus its last change, which counts as 0 after a value with kStays
};

/// Predicts the values of a column. A column is stored as the differences from the predicted values.
class ColumnPredictor {
 public:
  std::int64_t predicted(Trend trend) const { return last_ + (trend == Trend::kGoesOn ? change_ : 0); }
  void learn(std::int64_t value, Trend trend) {
    change_ = trend == Trend::kGoesOn ? value - last_ : 0;
    last_ = value;
  }

 private:
  std::int64_t last_ = 0, change_ = 0;
};

/// Appends a table. Each column is a varint, the unit of which all its values are multiples, then a signed
/// varint per value: its difference, in units, from the value that `trend` predicts. The first prediction is
/// 0.
void writeColumns(const Columns& table, Trend trend, Bytes& out);

/// Reads a table with this number of columns and rows. Empty if the bytes do not contain one.
std::optional<Columns> readColumns(BytesView bytes, std::size_t columns, std::size_t rows, Trend trend);

/// Largest size of a written table [bytes].
constexpr std::size_t mostColumnBytes(std::size_t columns, std::size_t rows) {
  return columns * (rows + 1) * 5;
}

/// `value / step` rounded to the nearest whole number; 0 if it is not finite or too large.
inline std::int32_t wholeSteps(double value, double step) {
  const double steps = value / step;
  if (!(std::abs(steps) < 2147483000.0)) return 0;
  // Without branches, because the signs are random.
  return static_cast<std::int32_t>(steps + std::copysign(0.5, steps));
}

}  // namespace fulbito
