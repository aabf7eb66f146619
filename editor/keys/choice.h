// A row of a list that is searched by typing: a command, a node, a tree, a file.
#ifndef COPPICE_EDITOR_KEYS_CHOICE_H_
#define COPPICE_EDITOR_KEYS_CHOICE_H_

#include <functional>
#include <string>
#include <vector>

namespace coppice::editor {

struct Choice {
  std::string title;
  std::string note;  ///< shown dim at the right end
  std::string kind;  ///< shown dim in front
  int score = 0;
  std::function<void()> run;
};

/// The rows that fit what was typed, best first.
using ChoiceSource = std::function<std::vector<Choice>(const std::string& typed)>;

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_CHOICE_H_
