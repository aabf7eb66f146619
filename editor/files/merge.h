// Two people changed the same file: a three-way merge that knows tags and attributes, so that
// changes of different nodes, and of different attributes of one node, do not meet.
//
//   const MergedText merged = MergeTexts(before, mine, theirs);
//
// What neither has touched stays byte for byte. Where both changed the same place in different
// ways, mine stays and a conflict tells. After S. Khanna, K. Kunal, B. C. Pierce, "A formal
// investigation of diff3", FSTTCS 2007, on tokens of XML in the place of lines.
#ifndef COPPICE_EDITOR_FILES_MERGE_H_
#define COPPICE_EDITOR_FILES_MERGE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

struct MergeConflict {
  std::uint32_t offset = 0;  ///< in the merged text
  std::string mine;
  std::string theirs;
};

struct MergedText {
  std::string text;  ///< may be malformed if both changed the nesting
  std::vector<MergeConflict> conflicts;
};

MergedText MergeTexts(std::string_view before, std::string_view mine, std::string_view theirs);

/// The pieces that a merge never cuts: "<Tag", " name='value'", "/>", "</Tag>", a comment, what
/// stands between. Together they are the text. Never fails, whatever the text is.
std::vector<std::string_view> XmlPieces(std::string_view text);

/// For each piece of `before` its number in `after`, rising, or -1. Common pieces are as many as
/// can be unless the texts are very different.
std::vector<int> MatchPieces(const std::vector<std::string_view>& before,
                             const std::vector<std::string_view>& after);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_MERGE_H_
