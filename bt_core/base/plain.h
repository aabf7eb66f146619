// What a terminal is shown of others: names and texts of their files, robots and pages may hold
// what it would obey.
#ifndef COPPICE_BT_CORE_BASE_PLAIN_H_
#define COPPICE_BT_CORE_BASE_PLAIN_H_

#include <string>
#include <string_view>

namespace coppice {

/// The text with control characters written out, but for ends of lines and tabs: as "\x1B", and
/// those that may stand in JSON (DEL, and C1 of ISO 6429, two bytes of UTF-8) so that it remains
/// JSON, as "\u009B".
std::string Plain(std::string_view text);

/// The same in one line: its ends are written out, too.
std::string PlainLine(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_PLAIN_H_
