#include "replays/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulbito {
namespace {

/// How a value is predicted from the two before it. The numbers stand in files.
enum class Predictor : std::uint8_t { kNone, kLast, kLine };
constexpr int kPredictors = 3;

// All arithmetic is modulo 2^32: no difference overflows, and each can be undone.

std::uint32_t predict(int predictor, std::uint32_t last, std::uint32_t second_last) {
  switch (static_cast<Predictor>(predictor)) {
    case Predictor::kLast:
      return last;
    case Predictor::kLine:
      return 2 * last - second_last;
    case Predictor::kNone:
      break;
  }
  return 0;
}

std::uint32_t folded(std::uint32_t difference) { return (difference << 1) ^ (~(difference >> 31) + 1); }
std::uint32_t unfolded(std::uint32_t value) { return (value >> 1) ^ (~(value & 1) + 1); }

/// The predictor that leaves least, by the sum of what it leaves.
int bestPredictor(const Columns& table, std::size_t column) {
  std::array<std::uint64_t, kPredictors> costs{};
  std::uint32_t last = 0, second_last = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = static_cast<std::uint32_t>(table.at(column, row));
    costs[0] += folded(value);
    costs[1] += folded(value - last);
    costs[2] += folded(value - (2 * last - second_last));
    second_last = last;
    last = value;
  }
  return static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
}

/// Appends what a predictor leaves of one column; all its bits in one.
std::uint32_t leave(const Columns& table, std::size_t column, int predictor,
                    std::vector<std::uint32_t>& left) {
  std::uint32_t last = 0, second_last = 0, all = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = static_cast<std::uint32_t>(table.at(column, row));
    left.push_back(folded(value - predict(predictor, last, second_last)));
    all |= left.back();
    second_last = last;
    last = value;
  }
  return all;
}

std::size_t planesFor(std::uint32_t all) {
  std::size_t planes = 1;
  while (planes < 4 && (all >> (8 * planes)) != 0) ++planes;
  return planes;
}

}  // namespace

void packColumns(const Columns& table, PackedColumns& out) {
  out.bytes.clear();
  out.ends.clear();
  out.left.clear();
  std::uint32_t all = 0;
  out.bytes.push_back('\0');  // the number of planes, once it is known
  for (std::size_t column = 0; column < table.columns(); ++column) {
    const int predictor = bestPredictor(table, column);
    out.bytes.push_back(static_cast<char>(predictor));
    all |= leave(table, column, predictor, out.left);
  }
  const std::size_t planes = planesFor(all);
  out.bytes.front() = static_cast<char>(planes);
  for (std::size_t plane = 0; plane < planes; ++plane) {
    const std::size_t begin = out.bytes.size();
    out.bytes.resize(begin + out.left.size());
    char* to = out.bytes.data() + begin;
    for (const std::uint32_t value : out.left) *to++ = static_cast<char>(value >> (8 * plane));
    out.ends.push_back(out.bytes.size());
  }
}

std::size_t maxPackedSize(std::size_t columns, std::size_t rows) { return 1 + columns + 4 * columns * rows; }

std::optional<Columns> unpackColumns(BytesView bytes, std::size_t columns, std::size_t rows) {
  ByteReader in(bytes);
  const std::size_t planes = in.byte();
  const BytesView predictors = in.bytes(columns);
  const std::size_t count = columns * rows;
  if (!in.good() || planes < 1 || planes > 4 || in.left() != planes * count) return std::nullopt;
  const BytesView left = in.bytes(planes * count);
  Columns table(columns, rows);
  for (std::size_t row = 0; row < rows; ++row) table.addRow();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto predictor = static_cast<unsigned char>(predictors[column]);
    if (predictor >= kPredictors) return std::nullopt;
    std::uint32_t last = 0, second_last = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      std::uint32_t value = 0;
      for (std::size_t plane = 0; plane < planes; ++plane) {
        const auto part = static_cast<unsigned char>(left[plane * count + column * rows + row]);
        value |= std::uint32_t{part} << (8 * plane);
      }
      value = unfolded(value) + predict(predictor, last, second_last);
      table.at(column, row) = static_cast<std::int32_t>(value);
      second_last = last;
      last = value;
    }
  }
  return table;
}

std::int32_t wholeSteps(double value, double step) {
  const double steps = value / step;
  if (!(std::abs(steps) < 2147483000.0)) return 0;
  return static_cast<std::int32_t>(steps + (steps < 0.0 ? -0.5 : 0.5));
}

}  // namespace fulbito
