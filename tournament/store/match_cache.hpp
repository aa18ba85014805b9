#pragma once

#include <optional>
#include <string>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// A folder of matches that several tournaments may share at the same time. Each match is a log of its own,
/// named by its identity: FOLDER/ab/ab34....jsonl. The files may be deleted at any time.
class MatchCache {
 public:
  /// Creates the folder if it is missing. Errors: kIo.
  static Result<MatchCache> open(const std::string& folder);
  /// The match, if it is there. A damaged or unreadable file counts as missing, as does anything that is not
  /// a file.
  std::optional<MatchRow> find(const MatchId& id) const;
  /// Stores a match. Its file appears complete or not at all. It replaces a damaged file, and anything else
  /// at its path except a folder with content. Errors: kIo.
  Result<Added> add(const MatchRow& row) const;

 private:
  explicit MatchCache(std::string folder) : folder_(std::move(folder)) {}
  std::string folder_;
};

}  // namespace fulbito
