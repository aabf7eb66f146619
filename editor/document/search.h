// Finding texts in the trees of a project, and replacing them.
//
//   const Expected<Query> query = ParseQuery("key:goal");
//   const std::vector<Match> matches = Search(files, models, *query);
//   const std::vector<Edit> edits = Replace(files, matches, *query, "target");   // one per file
//
// What is typed may begin with "type:", "name:", "port:", "value:" or "key:", which narrows it
// down, and is a regular expression (search_pattern.h) between slashes: "value:/go(al)?/". Capitals
// count if there are any.
#ifndef COPPICE_EDITOR_DOCUMENT_SEARCH_H_
#define COPPICE_EDITOR_DOCUMENT_SEARCH_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/document/project_names.h"
#include "editor/document/search_pattern.h"

namespace coppice::editor {

/// What a text is in a tree.
enum class TextRole : std::uint8_t { kType, kName, kPort, kValue, kKey };

/// "type", "name", "port", "value" or "key".
const char* ToString(TextRole role);

/// A compiled search. Immutable.
class Query {
 public:
  Query(std::optional<TextRole> role, SearchPattern pattern)
      : role_(role), pattern_(std::move(pattern)) {}

  bool Wants(TextRole role) const { return !role_ || *role_ == role; }
  /// Only keys, and all that name one.
  bool is_for_keys() const { return role_ == TextRole::kKey; }
  const SearchPattern& pattern() const { return pattern_; }

 private:
  std::optional<TextRole> role_;
  SearchPattern pattern_;
};

Expected<Query> ParseQuery(std::string_view typed);

struct Match {
  std::size_t file = 0;
  ElementIndex element{0};
  TextRole role = TextRole::kType;
  std::string before;        ///< the whole value, name or tag
  std::uint32_t offset = 0;  ///< of the byte where it begins in the file
  std::string attribute;     ///< whose value or name it is; empty: the tag
};

/// The texts that fit, each once, in the order of the files; at most `limit`.
std::vector<Match> Search(const ProjectFiles& files, const NodeModels& models, const Query& query,
                          std::size_t limit = 10000);

/// What the text of a match is after the replacement.
std::string Replaced(const Match& match, const Query& query, const std::string& with);

/// Replaces it in these matches; one edit per file.
std::vector<Edit> Replace(const ProjectFiles& files, const std::vector<Match>& matches,
                          const Query& query, const std::string& with);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SEARCH_H_
