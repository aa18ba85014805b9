// Private header of replays: not installed.
#pragma once

#include "replays/coding/byte_io.hpp"
#include "replays/coding/columns.hpp"
#include "replays/coding/compression.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// Appends a table of commands: left and right of every robot in steps, one row a tick. First a varint a
/// robot: the unit of which all its commands are whole multiples.
void packCommands(const Columns& table, const CommandModel& model, Bytes& out);

/// Reverses it. Empty when the bytes are not those of such a table. With `Codec::kModelled` there are no
/// units told: that is version 2.
std::optional<Columns> unpackCommands(BytesView bytes, Codec codec, const CommandModel& model,
                                      std::size_t columns, std::size_t rows);

}  // namespace fulbito
