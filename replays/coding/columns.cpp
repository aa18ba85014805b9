#include "replays/coding/columns.hpp"

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

std::uint32_t unfolded(std::uint32_t value) { return (value >> 1) ^ (~(value & 1) + 1); }

}  // namespace

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

}  // namespace fulbito
