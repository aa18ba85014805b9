#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tournament/results/results.hpp"

namespace fulbito {

/// Where finished matches are kept. Safe to use from several threads.
class MatchStore {
 public:
  virtual ~MatchStore() = default;
  /// The result of a match, if it is there.
  virtual std::optional<MatchRow> find(const MatchId& id) const = 0;
  /// Keeps a finished match; once it returns, not even a power failure loses it. Errors: kIo naming the file;
  /// what was kept before stays whole.
  virtual Result<void> add(const MatchRow& row) = 0;
};

/// A store in memory.
class MatchMemory final : public MatchStore {
 public:
  MatchMemory();
  ~MatchMemory() override;
  std::optional<MatchRow> find(const MatchId& id) const override;
  Result<void> add(const MatchRow& row) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A log of matches in a file: a line of JSON per match (docs/results-format.md), appended and synced one by
/// one. The line of a match that was being written when the program or the machine died is cut off when the
/// log is opened to write; it is left out when it is read.
class MatchLog final : public MatchStore {
 public:
  /// Opens the log to append, or creates it, and locks it against other writers. Errors: kIo; kBadInput
  /// naming the line that is damaged or repeats a match with another result; kUsage when another process
  /// writes it.
  static Result<std::unique_ptr<MatchLog>> open(const std::string& file);
  ~MatchLog() override;
  std::optional<MatchRow> find(const MatchId& id) const override;
  /// Adding a match that is there changes nothing if its result is the same. Errors: also kBadInput when it
  /// differs: see `DifferentRow`.
  Result<void> add(const MatchRow& row) override;

 private:
  MatchLog();
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// All matches of a log in its order, without a torn last line. A missing file is an empty log only if
/// `may_miss`. Errors: as `MatchLog::open`.
Result<std::vector<MatchRow>> readMatchLog(const std::string& file, bool may_miss = false);

/// A line of a log, with its line end, and back. Errors: kBadInput saying what is wrong, without the file.
std::string toLine(const MatchRow& row);
Result<MatchRow> parseLine(std::string_view line);

/// A folder of matches that tournaments share, also at the same time: a file per match, by its identity.
class MatchCache {
 public:
  /// Creates the folder if it is missing. Errors: kIo.
  static Result<MatchCache> open(const std::string& folder);
  /// The result of a match, if it is there. A damaged file counts as missing.
  std::optional<MatchRow> find(const MatchId& id) const;
  /// Keeps a match. Errors: kIo; kBadInput when it is there with another result.
  Result<void> add(const MatchRow& row) const;

 private:
  std::string folder_;
};

/// Two runs of one match that differ.
struct MatchConflict {
  MatchRow first, second;
  std::string first_file, second_file;
};

/// The union of logs.
struct MergedLogs {
  std::map<MatchId, MatchRow> rows;
  std::vector<MatchConflict> conflicts;
  std::size_t repeated = 0;  ///< matches that were in more than one log, with the same result
};

/// Unions logs by match id. Errors: as `readMatchLog`.
Result<MergedLogs> mergeLogs(const std::vector<std::string>& files);

}  // namespace fulbito
