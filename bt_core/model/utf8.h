// Is a text UTF-8, and what of it can be shown?
#ifndef COPPICE_BT_CORE_MODEL_UTF8_H_
#define COPPICE_BT_CORE_MODEL_UTF8_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace coppice {

/// The offset of the first byte that is not part of a UTF-8 character (RFC 3629: no overlong forms,
/// no surrogates, nothing above U+10FFFF); the size of the text if there is none.
std::size_t FindInvalidUtf8(std::string_view text);

/// True if the text looks like UTF-16: by its byte order mark, or by a zero byte beside its first
/// character.
bool LooksLikeUtf16(std::string_view text);

/// What a stranger calls something, fit for one line of a screen: the characters of the text,
/// without those that control and those that are not seen but change how others are (that turn,
/// join or hide them). At most so many bytes; no character is cut into pieces.
std::string PlainText(std::string_view text, std::size_t longest);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_UTF8_H_
