// Which lines of a text are new or changed against another version of it, for the gutter beside
// the XML. Lines are compared as E. W. Myers does it, "An O(ND) difference algorithm and its
// variations", Algorithmica 1, 1986, doi 10.1007/BF01840446.
#ifndef COPPICE_EDITOR_FILES_LINE_CHANGES_H_
#define COPPICE_EDITOR_FILES_LINE_CHANGES_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

enum class LineMark : std::uint8_t {
  kSame,
  kAdded,
  kChanged,  ///< it stands where other lines were
  kRemoved   ///< the same, but lines before it are gone
};

/// Some lines in the place of others.
struct LineHunk {
  std::size_t before_begin, before_end;
  std::size_t after_begin, after_end;
};

/// What differs, from the top. Texts that have hardly a line in common are one hunk.
std::vector<LineHunk> CompareLines(std::string_view before, std::string_view after);

/// By line of `after`, of which there is at least one. Lines that are gone at the end mark the last
/// line.
std::vector<LineMark> MarkLines(std::string_view before, std::string_view after);

/// The lines of a text that a hunk has replaced.
std::string_view LinesOf(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_LINE_CHANGES_H_
