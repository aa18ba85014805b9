#include "tournament/store/merge.hpp"

#include <cstdint>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "engine/core/system/output_file.hpp"
#include "engine/core/system/regular_file.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;  // [bytes] per write

/// The texts in which rows with the same result may differ.
auto wordsOf(const MatchRow& row) {
  const MatchFaults& faults = row.result.faults;
  const std::string_view abandoned = faults.abandoned ? faults.abandoned->message : std::string_view();
  return std::tuple(row.teams, row.start, row.seed, faults.teams[0].failure, faults.teams[1].failure,
                    abandoned);
}

/// A union of logs that grows row by row.
class Merging {
 public:
  explicit Merging(const std::vector<std::string>& files) : files_(files) {}

  Result<void> readFile(std::size_t file);
  MergedLogs take() { return std::move(merged_); }

 private:
  void add(MatchRow row, std::size_t file);
  void meet(MatchRow& there, MatchRow row, std::size_t file);

  const std::vector<std::string>& files_;
  MergedLogs merged_;
  /// Index of the file that each row comes from.
  std::unordered_map<MatchId, std::uint32_t, WordOfId> sources_;
};

Result<void> Merging::readFile(std::size_t file) {
  const auto end = readRows(files_[file], false, [&](MatchRow row, std::size_t) {
    add(std::move(row), file);
    return Result<void>();
  });
  if (!end) return tl::unexpected<Error>(end.error());
  merged_.torn += end->torn ? 1 : 0;
  return {};
}

void Merging::add(MatchRow row, std::size_t file) {
  const MatchId id = row.id;
  const auto [place, is_new] = merged_.rows.try_emplace(id, std::move(row));
  if (is_new) {
    sources_[id] = static_cast<std::uint32_t>(file);
  } else {
    meet(place->second, std::move(row), file);  // `try_emplace` has not moved from `row`
  }
}

void Merging::meet(MatchRow& there, MatchRow row, std::size_t file) {
  if (!sameResult(there.result, row.result)) {
    const std::string& first_file = files_[sources_[row.id]];
    merged_.conflicts.push_back({there, std::move(row), first_file, files_[file]});
    return;
  }
  ++merged_.repeated;
  if (wordsOf(row) < wordsOf(there)) there = std::move(row);
}

}  // namespace

Result<MergedLogs> mergeLogs(const std::vector<std::string>& files) {
  Merging merging(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (auto read = merging.readFile(i); !read) return tl::unexpected<Error>(read.error());
  }
  return merging.take();
}

Result<void> writeMatchLog(const std::string& file, const std::map<MatchId, MatchRow>& rows) {
  auto out = OutputFile::create(file);
  if (!out) return tl::unexpected<Error>(out.error());
  std::string block(logHeader());
  for (const auto& [id, row] : rows) {
    block += toLine(row);
    if (block.size() < kBlock) continue;
    if (auto written = out->write(block); !written) return written;
    block.clear();
  }
  return out->write(block).and_then([&] { return out->commit(); }).and_then([&] {
    return syncFolderOf(file);
  });
}

}  // namespace fulbito
