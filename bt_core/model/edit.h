// A change of a text as a value: which bytes go and which come in their place. What it does not
// name stays as it is, byte for byte.
//
//   const Edit edit = SetAttribute(document, node, "msec", "500");       // element_edits.h
//   const Edit undo = Inverse(edit, document.text());
//   const std::string after = Apply(edit, document.text());
//   Apply(undo, after) == document.text()
//
// An undo stack is a stack of inverses: it costs the changed bytes only, so it need not end.
#ifndef COPPICE_BT_CORE_MODEL_EDIT_H_
#define COPPICE_BT_CORE_MODEL_EDIT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coppice {

struct Splice {
  std::uint32_t offset = 0;   ///< in the text before the edit
  std::uint32_t removed = 0;  ///< bytes
  std::string inserted;
};

/// Replaces the bytes from `begin` up to `end`.
inline Splice Replacement(std::size_t begin, std::size_t end, std::string text) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin),
          std::move(text)};
}

/// In the order of their offsets, not overlapping.
using Edit = std::vector<Splice>;

/// The text after the edit.
std::string Apply(const Edit& edit, std::string_view text);

/// The edit that turns Apply(edit, text) back into `text`.
Edit Inverse(const Edit& edit, std::string_view text);

/// Where a byte of the text lies after the edit. What is inserted in front of it moves it; a
/// removed byte lies where its replacement begins.
std::uint32_t MapOffset(const Edit& edit, std::uint32_t offset);

/// Both edits at once. They must be about the same text and about different places of it.
Edit Merge(Edit a, const Edit& b);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_EDIT_H_
