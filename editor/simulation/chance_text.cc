#include "editor/simulation/chance_text.h"

#include <cstddef>

#include "editor/simulation/script_text.h"

namespace coppice::editor {
namespace {

std::string ChoiceText(const std::vector<KeyValue>& choice) {
  std::string text = choice.front().key + ": ";
  for (std::size_t i = 0; i < choice.size(); ++i) {
    if (i > 0) text += i + 1 < choice.size() ? ", " : " or ";
    text += choice[i].text;
  }
  return text;
}

}  // namespace

std::string OriginOf(const RandomPlay& play) {
  const std::string& path = play.where.file;
  if (path.empty()) return {};
  return path.substr(path.rfind('/') + 1) + ":" + std::to_string(play.where.line);
}

std::vector<std::string> LinesOf(const RandomPlay& play) {
  std::vector<std::string> lines;
  for (const std::vector<KeyValue>& choice : play.set) lines.push_back(ChoiceText(choice));
  for (const PlacedRule& placed : play.leaves) {
    lines.push_back(placed.rule.pattern + ": " + PrintScript(placed.rule.script));
  }
  if (play.lasts > Duration(0)) lines.push_back("for " + PrintDuration(play.lasts));
  return lines;
}

}  // namespace coppice::editor
