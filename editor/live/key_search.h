// Finding a key of the blackboard, and showing as much of a large value as a person reads.
#ifndef COPPICE_EDITOR_LIVE_KEY_SEARCH_H_
#define COPPICE_EDITOR_LIVE_KEY_SEARCH_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace coppice::editor {

/// Whether every word of `words` is in "SCOPE/NAME" or in the value, capital or not. No words: yes.
bool IsKeyFound(const std::string& path, const std::string& value, const std::string& words);

/// The value, or its beginning and how much is missing: `{"stamp": 3, ... (51200 bytes in all)`.
/// No character is cut into pieces.
std::string BeginningOf(const std::string& value, std::size_t most_bytes);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEY_SEARCH_H_
