#include "bt_core/model/edit.h"

#include <algorithm>

namespace coppice {

std::string Apply(const Edit& edit, std::string_view text) {
  std::string result;
  result.reserve(text.size());
  std::size_t at = 0;
  for (const Splice& splice : edit) {
    result += text.substr(at, splice.offset - at);
    result += splice.inserted;
    at = std::size_t{splice.offset} + splice.removed;
  }
  return result += text.substr(at);
}

Edit Inverse(const Edit& edit, std::string_view text) {
  Edit inverse;
  inverse.reserve(edit.size());
  std::uint32_t grown = 0;  // by the splices so far; wraps around if it has shrunk
  for (const Splice& splice : edit) {
    const auto inserted = static_cast<std::uint32_t>(splice.inserted.size());
    inverse.push_back(
        {splice.offset + grown, inserted, std::string(text.substr(splice.offset, splice.removed))});
    grown += inserted - splice.removed;
  }
  return inverse;
}

std::uint32_t MapOffset(const Edit& edit, std::uint32_t offset) {
  std::uint32_t grown = 0;
  for (const Splice& splice : edit) {
    if (splice.offset > offset) break;
    if (offset < splice.offset + splice.removed) return splice.offset + grown;
    grown += static_cast<std::uint32_t>(splice.inserted.size()) - splice.removed;
  }
  return offset + grown;
}

Edit Merge(Edit a, const Edit& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::stable_sort(a.begin(), a.end(),
                   [](const Splice& x, const Splice& y) { return x.offset < y.offset; });
  return a;
}

}  // namespace coppice
