#pragma once

#include <optional>

#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"
#include "replays/coding/columns.hpp"

namespace fulbito {

/// Appends a table of samples in steps: x, y and heading of every body (of a ball x and y), one row a sample.
void packSamples(const Columns& table, const RecordingHeader& header, Bytes& out);

/// Reverses it. Empty when the bytes are not those of such a table.
std::optional<Columns> unpackSamples(BytesView bytes, const RecordingHeader& header, std::size_t rows);

}  // namespace fulbito
