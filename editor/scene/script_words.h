// The words of a script that may be keys, and what it does with them.
#ifndef COPPICE_EDITOR_SCENE_SCRIPT_WORDS_H_
#define COPPICE_EDITOR_SCENE_SCRIPT_WORDS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::editor {

struct ScriptWord {
  std::string text;        ///< with '@', if it has one
  std::size_t offset = 0;  ///< in the script
  bool reads = false;
  bool writes = false;
};

/// In the order of the script, every time that they stand there; names of enums too, which only
/// the robot knows. Of what is no script, those that can be read.
std::vector<ScriptWord> WordsOf(std::string_view script);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_SCRIPT_WORDS_H_
