#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace fulbito {

/// A table of whole numbers, kept column by column: each column is one quantity over time.
class Columns {
 public:
  Columns() = default;
  Columns(std::size_t columns, std::size_t capacity) : columns_(columns), capacity_(capacity) {
    values_.resize(columns * capacity);
  }

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  void clear() { rows_ = 0; }
  /// Makes one more row; all its values must be set.
  std::size_t addRow() { return rows_++; }
  std::int32_t& at(std::size_t column, std::size_t row) { return values_[column * capacity_ + row]; }
  std::int32_t at(std::size_t column, std::size_t row) const { return values_[column * capacity_ + row]; }

 private:
  std::size_t columns_ = 0, capacity_ = 0, rows_ = 0;
  std::vector<std::int32_t> values_;
};

/// `value / step` as the nearest whole number; 0 for what is not finite or too large.
inline std::int32_t wholeSteps(double value, double step) {
  const double steps = value / step;
  if (!(std::abs(steps) < 2147483000.0)) return 0;
  return static_cast<std::int32_t>(steps + std::copysign(0.5, steps));  // branch-free: signs are random
}

}  // namespace fulbito
