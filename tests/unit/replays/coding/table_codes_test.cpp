#include <limits>

#include "engine/core/math/random.hpp"
#include "replays/chunks/command_code.hpp"
#include "replays/chunks/sample_code.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

constexpr std::int32_t kHigh = 2147483000, kLow = -kHigh;  // as far as wholeSteps goes

Columns tableOf(std::size_t columns, std::size_t rows,
                const std::function<std::int32_t(std::size_t, std::size_t)>& at) {
  Columns table(columns, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    table.addRow();
    for (std::size_t column = 0; column < columns; ++column) table.at(column, row) = at(column, row);
  }
  return table;
}

bool same(const Columns& a, const Columns& b) {
  for (std::size_t row = 0; row < a.rows(); ++row) {
    for (std::size_t column = 0; column < a.columns(); ++column) {
      if (a.at(column, row) != b.at(column, row)) return false;
    }
  }
  return a.rows() == b.rows();
}

std::size_t checkCommands(const Columns& table, const CommandModel& model) {
  Bytes bytes;
  packCommands(table, model, bytes);
  const auto back = unpackCommands(bytes, model, table.columns(), table.rows());
  REQUIRE(back);
  REQUIRE(same(*back, table));
  return bytes.size();
}

void checkSamples(const Columns& table, const RecordingHeader& header) {
  Bytes bytes;
  packSamples(table, header, bytes);
  const auto back = unpackSamples(bytes, header, table.rows());
  REQUIRE(back);
  REQUIRE(same(*back, table));
}

const CommandModel kModel{827, 4000, 8000, 63488, 66662};

}  // namespace

TEST_CASE("commands come back, whatever they are and whatever the model", "[unit]") {
  Rng rng(3, test::kTestStream);
  const auto extreme = [&](std::size_t, std::size_t) { return rng.below(2) == 0 ? kLow : kHigh; };
  const auto noise = [&](std::size_t, std::size_t) {
    return static_cast<std::int32_t>(rng.below(9217)) - 4608;
  };
  const auto all = [&](std::size_t, std::size_t) { return static_cast<std::int32_t>(rng.bits32()) / 2; };
  const CommandModel widest{1000000000, 0, 1000000000, 131072, 0};
  for (const CommandModel& model : {CommandModel{}, kModel, widest}) {
    checkCommands(tableOf(6, 300, extreme), model);
    checkCommands(tableOf(6, 300, noise), model);
    checkCommands(tableOf(2, 300, all), model);
    checkCommands(tableOf(6, 1, noise), model);
  }
}

TEST_CASE("commands cost little where robots stand still or speed up as they can", "[unit]") {
  const auto still = tableOf(12, 300, [](std::size_t, std::size_t) { return 0; });
  CHECK(checkCommands(still, kModel) < 60);
  // Both wheels gain what they can, in steps, and then lose it again.
  const auto ramp = tableOf(12, 300, [](std::size_t, std::size_t row) {
    const auto phase = static_cast<std::int32_t>(row % 20);
    return (phase < 10 ? phase : 20 - phase) * 413 + 1;
  });
  const std::size_t known = checkCommands(ramp, kModel), unknown = checkCommands(ramp, {});
  CHECK(known < 3600 / 2);
  CHECK(2 * known < unknown);
}

TEST_CASE("commands in coarse units come back exactly and cost less", "[unit]") {
  Rng rng(6, test::kTestStream);
  const auto fine = tableOf(
      4, 300, [&](std::size_t, std::size_t) { return static_cast<std::int32_t>(rng.below(9217)) - 4608; });
  const auto mixed = tableOf(4, 300, [&](std::size_t column, std::size_t row) {
    const std::int32_t value = fine.at(column, row);
    return column < 2 ? value / 18 * 18 : value;  // the first robot speaks in steps of 18
  });
  const auto coarse =
      tableOf(4, 300, [&](std::size_t column, std::size_t row) { return fine.at(column, row) / 18 * 18; });
  const std::size_t all = checkCommands(fine, kModel), half = checkCommands(mixed, kModel),
                    few = checkCommands(coarse, kModel);
  // log2(18) = 4.2 bits of each number: 315 bytes of a robot's 600.
  CHECK(half + 280 < all);
  CHECK(few + 560 < all);
}

TEST_CASE("a unit that no robot can have is refused", "[unit]") {
  const auto table = tableOf(2, 5, [](std::size_t, std::size_t row) { return static_cast<int>(row); });
  Bytes bytes;
  packCommands(table, kModel, bytes);
  REQUIRE(bytes.front() == 1);
  bytes.front() = 0;
  CHECK_FALSE(unpackCommands(bytes, kModel, 2, 5));
  CHECK_FALSE(unpackCommands({}, kModel, 2, 5));
}

TEST_CASE("cut or longer commands are refused", "[unit]") {
  Rng rng(4, test::kTestStream);
  const auto table =
      tableOf(4, 50, [&](std::size_t, std::size_t) { return static_cast<std::int32_t>(rng.below(900)); });
  Bytes bytes;
  packCommands(table, kModel, bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    REQUIRE_FALSE(unpackCommands(bytes.substr(0, size), kModel, 4, 50));
  }
  CHECK_FALSE(unpackCommands(bytes + "x", kModel, 4, 50));
}

TEST_CASE("samples come back, with headings in the range of a turn", "[unit]") {
  const RecordingHeader header = test::sampleHeader();
  const std::size_t columns = 5 * 3 + 2;
  Rng rng(5, test::kTestStream);
  const auto heads = [](std::size_t column) { return column < 12 ? column % 3 == 2 : column == 16; };
  checkSamples(tableOf(columns, 200,
                       [&](std::size_t column, std::size_t) {
                         if (heads(column)) return static_cast<std::int32_t>(rng.below(1024)) - 512;
                         return rng.below(2) == 0 ? kLow : kHigh;
                       }),
               header);
  // Turning on and on: a heading is continued over the seam.
  checkSamples(tableOf(columns, 200,
                       [&](std::size_t column, std::size_t row) {
                         return heads(column) ? static_cast<std::int32_t>((row * 37) % 1024) - 512 : 5;
                       }),
               header);
}

TEST_CASE("a heading of half a turn may be read as half a turn the other way", "[unit]") {
  const RecordingHeader header = test::sampleHeader();
  const auto table = tableOf(17, 1, [](std::size_t column, std::size_t) { return column == 2 ? 512 : 0; });
  Bytes bytes;
  packSamples(table, header, bytes);
  CHECK(unpackSamples(bytes, header, 1)->at(2, 0) == -512);
}

}  // namespace fulbito
