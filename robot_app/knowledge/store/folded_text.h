// Texts as they are compared: what people type and say, names, notes.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_FOLDED_TEXT_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_FOLDED_TEXT_H_

#include <string>
#include <string_view>
#include <vector>

namespace coppice::robot::knowledge {

/// In small letters without accents: "Hörsaal", "HOERSAAL" and "hoersaal" are the same. What is no
/// letter or digit is one space; an apostrophe within a word is nothing ("what's" is "whats").
/// Takes any bytes.
std::string Folded(std::string_view text);

/// The words of a folded text.
std::vector<std::string> Words(std::string_view text);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_FOLDED_TEXT_H_
