#include "editor/diff/diff_sentence.h"

namespace coppice::editor {
namespace {

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

// "below \"round\"", "the root".
std::string Below(const Scene& scene, std::uint32_t node) {
  const std::uint32_t parent = scene.nodes[node].parent;
  return parent == kNoSceneNode ? "the root" : "below " + Quoted(scene.nodes[parent].name);
}

std::string Place(const Scene& scene, std::uint32_t node) {
  return "place " + std::to_string(scene.nodes[node].number);
}

std::string Moved(const NodeDiff& diff, const Scene& before, const Scene& after) {
  const std::string old_place = Below(before, diff.before);
  const std::string place = Below(after, diff.after);
  const std::string from = Place(before, diff.before);
  const std::string to = Place(after, diff.after);
  if (old_place != place) return "was moved from " + old_place + " to " + place;
  if (from == to) return "has changed its place among its siblings " + place;
  return "was moved from " + from + " to " + to + " " + place;
}

std::string Changed(const AttributeChange& change) {
  const bool is_of_node = change.name == "type" || change.name == "name";
  const std::string what = (is_of_node ? "its " : "") + change.name;
  if (change.before.empty())
    return what + " is now " + Quoted(change.after) + " and was not set before";
  if (change.after.empty()) return what + " was " + Quoted(change.before) + " and is no longer set";
  return what + " was " + Quoted(change.before) + " and is now " + Quoted(change.after);
}

std::string Changed(const NodeDiff& diff) {
  std::string text = "has changed";
  const char* separator = ": ";
  for (const AttributeChange& change : diff.attributes) {
    text += separator + Changed(change);
    separator = "; ";
  }
  return text;
}

}  // namespace

std::string Sentence(const NodeDiff& diff, const Scene& before, const Scene& after) {
  const bool is_removed = diff.after == kNoSceneNode;
  const SceneNode& node = is_removed ? before.nodes[diff.before] : after.nodes[diff.after];
  const std::string subject = Quoted(node.name) + " ";
  switch (diff.kind) {
    case DiffKind::kAdded:
      return subject +
             (after.nodes[diff.after].parent == kNoSceneNode ? "was added as " : "was added ") +
             Below(after, diff.after);
    case DiffKind::kRemoved:
      return subject + "was removed; it was " + Below(before, diff.before);
    case DiffKind::kMoved:
      return subject + Moved(diff, before, after);
    case DiffKind::kChanged:
      return subject + Changed(diff);
  }
  return subject;
}

}  // namespace coppice::editor
