// What is searched for in one text: characters as they are, or a regular expression.
//
//   const auto pattern = SearchPattern::Regular("go(al)?", /*fold_case=*/true);
//   pattern->In("{goal}", "target");   // {{1, 5, "target"}}
//
// Whoever types a pattern does not know how long it takes. Therefore a regular expression may have
// at most 1 000 characters and no back references, is matched in polynomial time where the
// library can do that, and looks at the first 4 096 bytes of a text only. Plain characters are
// found everywhere.
#ifndef COPPICE_EDITOR_DOCUMENT_SEARCH_PATTERN_H_
#define COPPICE_EDITOR_DOCUMENT_SEARCH_PATTERN_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

/// Immutable; copies are cheap.
class SearchPattern {
 public:
  /// Bytes of a text in which a regular expression looks.
  static constexpr std::size_t kLongestText = 4096;
  static constexpr std::size_t kLongestExpression = 1000;

  /// `fold_case`: ASCII letters are the same as capitals. The text must not be empty.
  static SearchPattern Literal(std::string_view text, bool fold_case);
  /// ECMAScript. Nothing if it is malformed, too long or refers back.
  static std::optional<SearchPattern> Regular(std::string_view text, bool fold_case);

  struct Found {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string with;  ///< what stands there after the replacement
  };
  /// Where it is in the text, from left to right, without overlap and never empty. `with` may name
  /// the groups of a regular expression: $1.
  std::vector<Found> In(std::string_view text, const std::string& with = {}) const;

 private:
  struct Expression;
  std::vector<Found> FindLiteral(std::string_view text, const std::string& with) const;
  std::vector<Found> FindExpression(std::string_view text, const std::string& with) const;

  std::string literal_;  // in small letters if they are all the same
  bool fold_case_ = false;
  std::shared_ptr<const Expression> expression_;  // instead of `literal_`
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SEARCH_PATTERN_H_
