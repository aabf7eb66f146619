#include "bt_core/cli/replay/replay_tree.h"

#include <cstdio>

#include "bt_core/base/json.h"
#include "bt_core/base/plain.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

const char* ColorOf(Status status) {
  switch (status) {
    case Status::kRunning:
      return "\x1b[33m";
    case Status::kSuccess:
      return "\x1b[32m";
    case Status::kFailure:
      return "\x1b[31m";
    case Status::kSkipped:
      return "\x1b[36m";
    case Status::kIdle:
      return "\x1b[90m";
  }
  return "";
}

std::size_t DepthOf(const TreeDescription& tree, NodeIndex node) {
  std::size_t depth = 0;
  for (; tree.nodes[node].parent != node; node = tree.nodes[node].parent) ++depth;
  return depth;
}

std::string Seconds(Duration time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

}  // namespace

TreePicture PictureOf(const Recording& run, std::size_t entry) {
  TickView view = run.Before(entry);
  const TreeDescription& tree = run.trees()[run.TreeOf(entry)];
  StatusFollower follower(ShapeOf(tree), view.statuses);
  TreePicture picture{view.events.tick,
                      view.events.start,
                      view.events.result,
                      {},
                      std::vector<Status>(tree.nodes.size(), Status::kIdle),
                      std::move(view.values)};
  EventReader reader(view.events.words);
  for (Event event; reader.Next(event);) {
    follower.Apply(event);
    if (event.is_result()) picture.last[event.index] = event.status();
    const bool writes = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
    if (writes && event.index < picture.values.size()) picture.values[event.index] = event.bytes;
  }
  picture.statuses = follower.statuses();
  return picture;
}

std::string NodeLine(const TreeDescription& tree, const TreePicture& picture, NodeIndex node,
                     bool colored) {
  const Status result = picture.last[node];
  const Status status = picture.statuses[node];
  const Status shown = result != Status::kIdle ? result : status;
  std::string text = ToString(shown);
  if (result == Status::kIdle && status == Status::kIdle) text = "-";
  text.resize(9, ' ');
  const std::string& path = tree.nodes[node].path;
  const std::string name = path.substr(path.rfind('/') + 1);
  std::string line = text + std::string(2 * DepthOf(tree, node), ' ') + name;
  const std::string& id = tree.nodes[node].id;
  if (name != id && name.rfind(id + "::", 0) != 0) line += "  <" + id + ">";
  return colored ? ColorOf(shown) + Plain(line) + "\x1b[0m" : line;
}

std::string PrintPicture(const TreeDescription& tree, const TreePicture& picture, Time start) {
  std::string text = "tick " + std::to_string(picture.tick) + " at " +
                     Seconds(picture.time - start) + " s: " + ToString(picture.result) + "\n";
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    text += NodeLine(tree, picture, i, false) + "\n";
  }
  for (SlotIndex i{0}; i < tree.slots.size(); ++i) {
    const DescribedSlot& slot = tree.slots[i];
    if (!slot.has_key || FormOfValue(picture.values[i]) == ValueForm::kEmpty) continue;
    text += slot.scope + "{" + slot.name + "} = " + PrintValueBytes(picture.values[i]) + "\n";
  }
  return text;
}

std::string PictureToJson(const TreeDescription& tree, const TreePicture& picture, Time start) {
  JsonObject nodes;
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    nodes.Add(tree.nodes[i].path, JsonObject()
                                      .AddText("status", ToString(picture.statuses[i]))
                                      .AddText("result", ToString(picture.last[i]))
                                      .Finish());
  }
  JsonObject keys;
  for (SlotIndex i{0}; i < tree.slots.size(); ++i) {
    const DescribedSlot& slot = tree.slots[i];
    if (slot.has_key) {
      keys.Add(slot.scope + "{" + slot.name + "}", ValueBytesToJson(picture.values[i]));
    }
  }
  return JsonObject()
      .AddText("type", "picture")
      .Add("tick", picture.tick)
      .Add("time", JsonSeconds(picture.time - start))
      .AddText("result", ToString(picture.result))
      .Add("nodes", nodes.Finish())
      .Add("keys", keys.Finish())
      .Finish();
}

}  // namespace coppice
