// What may be given to cv::FileStorage: its parsers call themselves for every level of a text,
// without a limit.
#ifndef COPPICE_ROBOT_APP_COMMON_LEARNING_FLAT_YAML_H_
#define COPPICE_ROBOT_APP_COMMON_LEARNING_FLAT_YAML_H_

#include <algorithm>
#include <string_view>

namespace coppice::robot {

/// Whether the text is YAML as OpenCV writes it, of a few levels.
inline bool IsFlatYaml(std::string_view text) {
  constexpr int kDeepest = 16;
  constexpr int kIndent = 4;  // of a level, at most
  int brackets = 0;
  int levels = 0;    // of the line: each colon and each dash may begin one
  int indented = 0;  // spaces in front of the first
  char before = '\n';
  for (const char c : text) {
    if (c == '\n') levels = indented = 0;
    indented += c == ' ' && levels == 0;
    levels += c == ':' || (c == ' ' && before == '-');
    brackets += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (std::max(brackets, levels + indented / kIndent) > kDeepest) return false;
    before = c;
  }
  return text.substr(0, 5) == "%YAML";  // it would read XML and JSON, too
}

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LEARNING_FLAT_YAML_H_
