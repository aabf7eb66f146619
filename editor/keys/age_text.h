// How long ago something was, as people say it.
#ifndef COPPICE_EDITOR_KEYS_AGE_TEXT_H_
#define COPPICE_EDITOR_KEYS_AGE_TEXT_H_

#include <cstdint>
#include <string>

namespace coppice::editor {

/// "a moment ago", "1 minute ago", "3 hours ago", "12 days ago".
std::string AgeText(std::int64_t seconds);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_AGE_TEXT_H_
