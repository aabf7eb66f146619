// Finding a key of the blackboard, and showing as much of a large value as a person reads.
#ifndef COPPICE_EDITOR_LIVE_KEY_SEARCH_H_
#define COPPICE_EDITOR_LIVE_KEY_SEARCH_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace coppice::editor {

/// Whether every word of `words` is in "SCOPE/NAME" or in the value, capital or not. No words: yes.
bool IsKeyFound(std::string_view path, std::string_view value, const std::string& words);

/// Whether the word is in the text, capital or not.
bool HasWord(std::string_view text, std::string_view word);

/// The value, or its beginning and how much is missing: `{"stamp": 3, ... (51200 bytes in all)`.
/// No character is cut into pieces.
std::string BeginningOf(std::string_view value, std::size_t most_bytes);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEY_SEARCH_H_
