#pragma once

#include <optional>

#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"
#include "replays/coding/columns.hpp"

namespace fulbito {

/// Appends a table of commands: left and right of every robot in steps, one row a tick. Starts with one
/// varint per robot: the unit of which all its commands are whole multiples.
void packCommands(const Columns& table, const CommandModel& model, Bytes& out);

/// Reverses it. Empty when the bytes are not those of such a table.
std::optional<Columns> unpackCommands(BytesView bytes, const CommandModel& model, std::size_t columns,
                                      std::size_t rows);

}  // namespace fulbito
