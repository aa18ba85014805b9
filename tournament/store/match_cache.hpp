#pragma once

#include <optional>
#include <string>

#include "tournament/store/match_store.hpp"

namespace fulbito {

/// A folder of matches that tournaments share, also at the same time: a log of one match each, by its
/// identity: FOLDER/ab/ab34....jsonl. They may be deleted at any time.
class MatchCache {
 public:
  /// Creates the folder if it is missing. Errors: kIo.
  static Result<MatchCache> open(const std::string& folder);
  /// The match, if it is there. A damaged or unreadable file counts as missing, and so does what is no file.
  std::optional<MatchRow> find(const MatchId& id) const;
  /// Keeps a match: its file appears complete or not at all, and replaces a damaged one, and what is no file
  /// but a folder with content. Errors: kIo.
  Result<Added> add(const MatchRow& row) const;

 private:
  explicit MatchCache(std::string folder) : folder_(std::move(folder)) {}
  std::string folder_;
};

}  // namespace fulbito
